#pragma once
#include "sdpd/system/sub_step.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Whether its sub-step begins with the rates of the part before (sdpd/README.md, Eq. (S100)), which are kept
/// for it in system.rates, and finds the temperatures that it needs. Others need those of the energies before
/// them.
bool looks_back(Reaction const& reaction);

/// The particles' progress over dt at frozen positions, and the chemical energy that goes to their internal
/// energies with it (sdpd/README.md, Eqs. (S61) ... (S65), (S100)); in as many parts as the heat asks for. It
/// waits as long as walls are held. Temperatures and pressures do not belong to the energies after it. Throws
/// PhysicsError when a particle leaves its equation of state, or reacts too fast for any number of parts.
SubStep reaction(System const& system, double dt);

} // namespace mesobridge::sdpd
