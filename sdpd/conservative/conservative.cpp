#include "sdpd/conservative/conservative.hpp"
#include "sdpd/boundary/mirror.hpp"
#include <numeric>

namespace mesobridge::sdpd {
namespace {

template <class F>
void renew_thermodynamics(System& system, F const& f) {
  Failure failure;
  for_each_range(system, [&](Range range) { f(*system.thermodynamics, range, failure); });
  system.stop_at(failure);
}

} // namespace

void kick(System& system, double dt) {
  auto& particles = system.particles;
  for_each_index(particles.size(), system.threads,
                 [&](std::size_t i) { particles.p[i] += particles.f[i] * dt; });
  count_wall_impulses(system, dt);
}

void kick_and_drift(System& system, double kick_dt, double drift_dt) {
  auto& particles = system.particles;
  auto move = [&](auto const& inverse_mass) {
    for_each_index(particles.size(), system.threads, [&](std::size_t i) {
      particles.p[i] += particles.f[i] * kick_dt;
      particles.q[i] += particles.p[i] * (drift_dt * inverse_mass(i));
    });
  };
  if (particles.mass.empty())
    move([](std::size_t) { return 1.0; });
  else
    move([&](std::size_t i) { return 1 / particles.mass[i]; });
  count_wall_impulses(system, kick_dt);
  move_walls(system, drift_dt);
}

void refresh_lists(System& system) {
  if (!system.neighbours.outdated(system.particles.q))
    return;
  Failure failure;
  for (std::size_t i = 0; i < system.size(); ++i)
    if (!std::isfinite(norm2(system.particles.q[i])))
      failure.report(system.particles.id[i], "its position is not finite any more; take a shorter time step");
  system.stop_at(failure);
  try {
    system.neighbours.renew(system.particles);
  } catch (PhysicsError const& error) { // the lists do not know where in the run they are
    throw PhysicsError(
        fmt::format("step {} (dt = {:.6g} reduced): {}", system.step, system.dt, error.what()));
  }
  ++system.renewals;
}

void thermodynamics_from_entropy(System& system) {
  renew_thermodynamics(system, [&](auto const& of, Range range, Failure& failure) {
    of.from_entropy(system.particles, range, failure);
  });
}

void response_from_temperature(System& system) {
  renew_thermodynamics(system, [&](auto const& of, Range range, Failure& failure) {
    of.response(system.particles, range, failure);
  });
}

void thermodynamics_from_energy(System& system) {
  renew_thermodynamics(system, [&](auto const& of, Range range, Failure& failure) {
    of.from_energy(system.particles, range, failure);
  });
}

void temperature_from_energy(System& system) {
  renew_thermodynamics(system, [&](auto const& of, Range range, Failure& failure) {
    of.temperature_from_energy(system.particles, range, failure);
  });
}

} // namespace mesobridge::sdpd
