#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// A heat bath at the set temperature T = 1, each particle for itself, over dt with the rate gamma > 0
/// (sdpd/README.md, Eq. (S31)). Momenta: the exact Ornstein-Uhlenbeck step
///     p' = a p + ((1 - a^2) m k_B T)^(1/2) G,   a = exp(-gamma dt),
/// less the mean of all, so that the centre of mass stays at rest. Energies: heat is conducted from the bath,
///     d eps = gamma C (T - T_i) dt + (2 k_B gamma C T_i T)^(1/2) dW,
/// the law of SdpdConduction with a partner of infinite heat capacity, whose step is exact at a frozen heat
/// capacity; it leaves the canonical measure exp(S/k_B - eps/k_B T)/T_i alone up to the error of that
/// freezing (the momenta's is exact at any dt). A step of an energy that would leave the equation of state
/// is not made. Does not conserve energy. Afterwards T is behind the energies (call
/// thermodynamics_from_energy).
void couple_to_bath(System& system, double gamma, double dt);

} // namespace mesobridge::sdpd
