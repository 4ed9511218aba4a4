#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Moves the particles of an SDPD fluid to a minimum of its free energy at their temperatures, without noise
/// and without motion: the energy that a start sets free is gone, and what is left of it is small beside k_B
/// T a particle, whatever their size. Momenta are zero afterwards. The same bits on any number of threads. By
/// FIRE (sdpd/README.md, Eq. (S83)). Throws PhysicsError when no minimum is found or a particle leaves the
/// equation of state.
void relax(System& system);

} // namespace mesobridge::sdpd
