#include "sdpd/conservative/refresh.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/conservative/pair_forces.hpp"
#include "sdpd/system/total_energy.hpp"

namespace mesobridge::sdpd {

void refresh_by(System& system, void (*thermodynamics)(System&)) {
  if (system.has_densities())
    find_pairs_and_densities(system);
  if (system.has_energies())
    thermodynamics(system);
  if (system.has_densities())
    find_forces(system);
  else
    find_pair_forces(system);
}

void refresh(System& system) {
  refresh_lists(system);
  refresh_by(system, thermodynamics_from_energy);
  system.kept_energy = total_energy(system) - system.energy_given();
}

void set_energies_from_temperatures(System& system) {
  if (!system.has_energies())
    return;
  refresh_lists(system);
  if (system.has_densities())
    find_pairs_and_densities(system);
  Failure failure;
  for_each_range(system, [&](Range range) {
    system.thermodynamics->energy_from_temperature(system.particles, range, failure);
  });
  system.stop_at(failure);
}

} // namespace mesobridge::sdpd
