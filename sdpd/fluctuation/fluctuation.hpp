#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Fluctuation and dissipation over dt (sdpd/README.md, Eq. (S11)), pair after pair in the order of the
/// lists, each by its exact Ornstein-Uhlenbeck step at the temperatures that the pair has then. What a pair's
/// kinetic energy loses goes to its two internal energies in equal parts, so that momentum and energy are
/// conserved to round-off; densities stay fixed. Without internal energies the temperature is the set one,
/// and every step is made. For the rest see PairIntegrator.
///
/// Pairs of a matching share no particle and are worked on in lanes. Velocities and energies are double
/// precision; coefficients, noise and directions are single, from positions within the block: they decide how
/// much is exchanged, to some 1e-6, not whether it is conserved.
void fluctuate(System& system, PairScheme scheme, double dt, bool second = false);

template <PairScheme scheme>
void one_after_the_other(System& system, double dt, bool second) {
  fluctuate(system, scheme, dt, second);
}

/// All pairs at once from the velocities and temperatures of the start (explicit Euler), with the heat that
/// conserves the energy exactly (Eq. (S25)). Stable for short time steps only; throws PhysicsError when an
/// internal energy leaves the equation of state.
void fluctuate_ser(System& system, double dt, bool second = false);

} // namespace mesobridge::sdpd
