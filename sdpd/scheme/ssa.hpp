#pragma once
#include "sdpd/step/conservative.hpp"
#include "sdpd/step/fluctuation_ssa.hpp"

namespace mesobridge::sdpd {

/// One step of Velocity Verlet at constant entropies, then Shardlow's splitting for fluctuation and
/// dissipation (Lie-Trotter, as in the thesis, section 4.1). Before and after it, eps, S, T, P and f belong
/// to the positions.
inline void step_ssa(System& system, double dt) {
  system.dt = dt;
  kick(system, dt / 2);
  drift(system, dt);
  refresh_lists(system);
  find_pairs_and_densities(system);
  thermodynamics_from_entropy(system);
  find_forces(system);
  kick(system, dt / 2);
  fluctuate_ssa(system, dt);
  thermodynamics_from_energy(system);
  find_forces(system);
  ++system.step;
}

} // namespace mesobridge::sdpd
