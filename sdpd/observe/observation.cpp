#include "sdpd/observe/observation.hpp"

namespace mesobridge::sdpd {

Observation observe(System const& system) {
  auto const& particles = system.particles;
  std::size_t const n = particles.size();
  std::vector<Index> place(n);
  for (std::size_t i = 0; i < n; ++i)
    place[particles.id[i]] = static_cast<Index>(i);
  Observation sum;
  sum.step = system.step;
  sum.potential = system.potential_energy;
  sum.wall_work = system.wall_work(), sum.given = system.energy_given();
  bool const densities = system.has_densities(), energies = system.has_energies();
  double mass = 0;
  for (Index const i : place) {
    double const m = particles.mass_of(i);
    sum.kinetic += 0.5 * norm2(particles.p[i]) / m;
    sum.momentum += particles.p[i], mass += m;
    if (energies)
      sum.internal += particles.eps[i], sum.T_int += densities ? particles.T[i] : 1 / particles.T[i];
    if (densities)
      sum.rho += particles.rho[i];
    if (system.reaction)
      sum.chemical += m * (1 - particles.progress[i]) * system.reaction->heat,
          sum.progress += m * particles.progress[i];
  }
  sum.progress /= mass;
  double const count = static_cast<double>(n), volume = system.volume();
  double const thermal = sum.kinetic - 0.5 * norm2(sum.momentum) / mass; // without the motion of the whole
  sum.T_kin = 2 * thermal / (3 * (count - 1) * system.boltzmann);
  if (energies)
    sum.T_int = densities ? sum.T_int / count : count / sum.T_int;
  sum.rho = densities ? sum.rho / count : mass / volume;
  sum.P = count * system.boltzmann * sum.T_kin / volume + system.virial / (3 * volume);
  return sum;
}

} // namespace mesobridge::sdpd
