#include "sdpd/fluctuation/langevin.hpp"
#include "sdpd/state/random.hpp"
#include "sdpd/system/sum_over_particles.hpp"

namespace mesobridge::sdpd {
namespace {

void couple_momenta(System& system, NoiseSource const& source, double decay) {
  auto& particles = system.particles;
  double const keep = 1 + decay, kick = std::sqrt(system.boltzmann * -decay * (2 + decay));
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      auto const G = gaussians_reference(source, particles.id[i], 0);
      double const spread = kick * std::sqrt(particles.mass_of(i));
      particles.p[i] = keep * particles.p[i] + spread * Vec3{G[0], G[1], G[2]};
    }
  });
  double const mass = sum_over_particles(system, [&](std::size_t i) { return particles.mass_of(i); });
  auto mean = [&](double Vec3::*component) {
    return sum_over_particles(system, [&](std::size_t i) { return particles.p[i].*component; }) / mass;
  };
  Vec3 const drift{mean(&Vec3::x), mean(&Vec3::y), mean(&Vec3::z)};
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i)
      particles.p[i] -= particles.mass_of(i) * drift;
  });
}

void couple_energies(System& system, NoiseSource const& source, double decay) {
  auto& particles = system.particles;
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      double const T = particles.T[i], C = 1 / particles.caloric[i].inverse_C_0;
      double const variance = system.boltzmann * C * T * -decay * (2 + decay);
      double const u =
          (T - 1) * C * decay + std::sqrt(variance) * gaussians_reference(source, particles.id[i], 1)[0];
      auto const& caloric = particles.caloric[i];
      try {
        double const T_1 =
            caloric.in_reach(u)
                ? caloric.T(u)
                : system.thermodynamics->state(particles, static_cast<Index>(i), particles.eps[i] + u).T;
        if (T_1 > 0)
          particles.eps[i] += u, particles.T[i] = T_1;
      } catch (PhysicsError const&) {
        continue; // there is no such state: the step is not made
      }
    }
  });
}

} // namespace

void couple_to_bath(System& system, double gamma, double dt) {
  NoiseSource const source(system.seed, Stream::bath, system.step);
  double const decay = std::expm1(-gamma * dt);
  couple_momenta(system, source, decay);
  if (system.has_energies())
    couple_energies(system, source, decay);
}

} // namespace mesobridge::sdpd
