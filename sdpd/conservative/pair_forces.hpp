#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// For DPD and DPDE: picks the pairs in range from the candidates; forces, virial and energy of the pair
/// potential. Throws PhysicsError when two particles are nearer than the potential is defined.
void find_pair_forces(System& system);

} // namespace mesobridge::sdpd
