#include "sdpd/system/total_energy.hpp"
#include "sdpd/system/sum_over_particles.hpp"

namespace mesobridge::sdpd {

double chemical_energy(System const& system) {
  auto const& particles = system.particles;
  return system.reaction->heat * sum_over_particles(system, [&](std::size_t i) {
           return particles.mass_of(i) * (1 - particles.progress[i]);
         });
}

double total_energy(System const& system) {
  auto const& particles = system.particles;
  auto const kinetic = [&](std::size_t i) { return 0.5 * norm2(particles.p[i]) / particles.mass_of(i); };
  if (!system.has_energies())
    return system.potential_energy + sum_over_particles(system, kinetic);
  double const without_chemical = system.potential_energy + sum_over_particles(system, [&](std::size_t i) {
                                    return particles.eps[i] + kinetic(i);
                                  });
  return system.reaction ? without_chemical + chemical_energy(system) : without_chemical;
}

} // namespace mesobridge::sdpd
