#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// For DPD and DPDE: picks the pairs in range from the candidates; forces, virial and energy of the pair
/// potential. Throws PhysicsError when two particles are nearer than the potential is defined.
void find_pair_forces(System& system);

/// Reports a pair, by its ids, that is at r nearer than `inner`, where its potential ends.
void report_too_near(Failure& failure, std::uint32_t a, std::uint32_t b, double r, double inner);

} // namespace mesobridge::sdpd
