#pragma once
#include "sdpd/system.hpp"

namespace mesobridge::sdpd {

/// Fluctuation and dissipation over dt by Shardlow's splitting: the pairs in turn, in the order of the lists
/// (theory sheet, section 3, SSA). The change of a pair's kinetic energy goes to its two internal energies in
/// equal parts, so that momentum and energy are conserved to round-off. Densities stay fixed. Needs the
/// caloric expansions of thermodynamics_from_entropy; leaves T behind the energies (call
/// thermodynamics_from_energy). Throws PhysicsError when an internal energy leaves the equation of state.
///
/// Pairs of a matching share no particle and are worked on in lanes. Velocities and energies are double
/// precision; coefficients, noise and directions are single: they decide how much is exchanged, to 1e-7, not
/// whether it is conserved.
void fluctuate_ssa(System& system, double dt);

/// The same pair after pair, with the same noise, in double precision throughout: the oracle of the fast one.
void fluctuate_ssa_plain(System& system, double dt);

} // namespace mesobridge::sdpd
