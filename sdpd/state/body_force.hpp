#pragma once
#include "md/vec3.hpp"

namespace mesobridge::sdpd {

/// An acceleration of all particles, in the units of its owner: the same everywhere, or a wave,
/// a cos(2 pi waves q/L), across an edge of length L (sdpd/README.md, Eq. (S54)).
struct BodyForce {
  Vec3 acceleration;
  int across = 2; ///< 0, 1, 2: a wave varies along x, y, z
  int waves = 0;  ///< in the length of the box, >= 0; 0: the same everywhere

  bool acts() const { return norm2(acceleration) > 0; }
};

} // namespace mesobridge::sdpd
