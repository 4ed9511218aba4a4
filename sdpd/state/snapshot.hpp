#pragma once
#include "sdpd/state/particles.hpp"

namespace mesobridge::sdpd {

/// The particles in the order of their ids, with positions in the box; forces and caloric expansions are left
/// out.
struct Snapshot : Particles {
  std::vector<double> virial; ///< see observe/virials.hpp; empty unless it was asked for
};

} // namespace mesobridge::sdpd
