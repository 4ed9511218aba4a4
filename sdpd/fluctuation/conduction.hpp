#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Heat conduction over dt by system.conduction, if there is any (sdpd/README.md, Eq. (S20), (S21)), pair
/// after pair in the order of the lists, each by its exact step (see SdpdConduction, DpdeConduction) at the
/// temperatures that the pair has then; pairs of a matching, which share no particle, in lanes. What one
/// particle gains the other loses, so that energy is conserved to round-off; momenta and densities stay.
///
///   ssa  every step is made. Throws PhysicsError when an energy leaves the equation of state.
///   ams  a step that would lead an energy out of the equation of state is not made.
///   ems  that, and a Metropolis test which makes the invariant measure exact at any dt.
///
/// With the heat delta = mean + s G, and mean', s' those of the step back from the proposed energies, ems
/// accepts with the probability min(1, e^a), where
///
///     a = sum_k [(S_k' - S_k)/k_B - ln T_k' + ln T_k] + G^2/2 - (delta + mean')^2/2s'^2 + ln(s/s'),
///
/// for DPDE without ln T. In lanes the two squares cancel in single precision: from there errors of a grow
/// with (mean/s)^2, which is large for particles of many k_B far from equilibrium alone.
///
/// Needs caloric expansions that begin at the energies (thermodynamics_from_energy), and leaves T behind
/// them. `second` draws other random numbers: for the second sweep of a step.
void conduct(System& system, PairScheme scheme, double dt, bool second = false);

} // namespace mesobridge::sdpd
