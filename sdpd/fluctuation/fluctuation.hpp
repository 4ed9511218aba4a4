#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Fluctuation and dissipation over dt (sdpd/README.md, Eq. (S11)). What a pair's kinetic energy loses goes
/// to its two internal energies in equal parts, so that momentum and energy are conserved to round-off;
/// densities stay fixed. SSA, AMS and EMS go pair after pair in the order of the lists, each by its exact
/// Ornstein-Uhlenbeck step at the temperatures that the pair has then:
///
///   ssa  every step is made. Throws PhysicsError when an internal energy leaves the equation of state.
///   ams  a step that would lead an internal energy out of the equation of state is not made.
///   ems  that, and a Metropolis test which makes the invariant measure exact at any dt.
///   ser  all pairs at once from the velocities and temperatures of the start (explicit Euler), with the heat
///        that conserves the energy exactly (Eq. (S25)). Stable for short time steps only; throws
///        PhysicsError when an internal energy leaves the equation of state.
///   ser_implicit, hybrid, entropy  see fluctuate_implicit, fluctuate_hybrid, fluctuate_entropies.
///
/// Needs the caloric expansions of thermodynamics_from_entropy; leaves T behind the energies (call
/// thermodynamics_from_energy). `second` draws other random numbers: for the second sweep of a step.
///
/// Pairs of a matching share no particle and are worked on in lanes. Velocities and energies are double
/// precision; coefficients, noise and directions are single, from positions within the block: they decide how
/// much is exchanged, to some 1e-6, not whether it is conserved.
void fluctuate(System& system, PairScheme scheme, double dt, bool second = false);
void fluctuate_ser(System& system, double dt, bool second = false);

} // namespace mesobridge::sdpd
