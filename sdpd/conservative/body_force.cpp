#include "sdpd/conservative/body_force.hpp"
#include "sdpd/system/sum_over_particles.hpp"
#include <numbers>

namespace mesobridge::sdpd {
namespace {

/// The work is the change of the kinetic energy, so that the energy balances to round-off.
void accelerate(System& system, double dt) {
  if (system.walls_held)
    return;
  auto& particles = system.particles;
  auto const& [acceleration, across, waves] = system.body_force;
  double const k = 2 * std::numbers::pi * waves / component(system.box.edge, across);
  system.body_work += sum_over_particles(system, [&](std::size_t i) {
    double const m = particles.mass_of(i),
                 share = waves > 0 ? std::cos(k * component(particles.q[i], across)) : 1;
    Vec3 const impulse = m * share * dt * acceleration, before = particles.p[i];
    particles.p[i] += impulse;
    return dot(impulse, before + 0.5 * impulse) / m;
  });
}

} // namespace

SubStep body_force(double dt) {
  using enum Conserved;
  return {.name = "body force",
          .conserves = {positions, internal_energies, entropies, energy},
          .noise = {},
          .run = [=](System& system) { accelerate(system, dt); }};
}

} // namespace mesobridge::sdpd
