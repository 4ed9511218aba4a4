#include "sdpd/conservative/conservative.hpp"
#include "sdpd/conservative/integrator.hpp"
#include "sdpd/conservative/pair_forces.hpp"

namespace mesobridge::sdpd::parts {
namespace {

/// The forces at new positions: by densities at constant entropies (SDPD), or from the pair potential.
void follow_positions(System& system) {
  refresh_lists(system);
  if (!system.has_densities())
    return find_pair_forces(system);
  find_pairs_and_densities(system);
  thermodynamics_from_entropy(system);
  find_forces(system);
}

} // namespace

SubStep kick(double dt) {
  using enum Conserved;
  return {.name = "kick",
          .conserves = {positions, internal_energies, entropies, momentum},
          .run = [=](System& system) { sdpd::kick(system, dt); }};
}

SubStep kick_and_drift(double kick_dt, double drift_dt) {
  using enum Conserved;
  return {.name = "kick and drift",
          .conserves = {internal_energies, entropies, momentum},
          .run = [=](System& system) { sdpd::kick_and_drift(system, kick_dt, drift_dt); }};
}

SubStep forces() {
  using enum Conserved;
  return {.name = "forces at the new positions", .conserves = {momenta, entropies}, .run = follow_positions};
}

} // namespace mesobridge::sdpd::parts
