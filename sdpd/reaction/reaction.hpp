#pragma once
#include "sdpd/system/sub_step.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// The particles' progress over dt at frozen positions, and the chemical energy that goes to their internal
/// energies with it (sdpd/README.md, Eqs. (S61) ... (S65)); in as many parts as the heat asks for. It waits
/// as long as walls are held. Temperatures and pressures belong to the energies before it, not after. Throws
/// PhysicsError when a particle leaves its equation of state, or reacts too fast for any number of parts.
SubStep reaction(System const& system, double dt);

} // namespace mesobridge::sdpd
