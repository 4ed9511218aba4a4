#pragma once
#include "md/box.hpp"
#include <vector>

namespace mesobridge::sdpd {

/// Per-particle values in the order of the ids, reduced.
struct Snapshot {
  std::vector<Vec3> q; ///< in the box
  std::vector<Vec3> p;
  std::vector<double> eps, rho, T, P; ///< empty where the method has none
  std::vector<double> virial = {};    ///< see observe/virials.hpp; empty unless it was asked for
};

} // namespace mesobridge::sdpd
