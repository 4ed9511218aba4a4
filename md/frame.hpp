#pragma once
#include "md/box.hpp"
#include <cstdint>
#include <vector>

namespace mesobridge::md {

/// One snapshot of all atoms, in the order of their ids, in the units of the run that it came from.
struct Frame {
  std::int64_t step = 0;
  Box box;
  std::vector<Vec3> positions; ///< inside the box
  std::vector<Vec3> velocities;
  std::vector<int> types; ///< from 1
};

} // namespace mesobridge::md
