#pragma once
#include "md/box.hpp"
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace mesobridge::workflows {

/// All particles at one step, in the order of their ids: what the writers of trajectories are given. In SI
/// scenes positions are in nm, times in ps and velocities in nm/ps, as in H5MD, because programs that draw
/// want numbers near 1; otherwise all is in the scene's reduced units.
struct ParticleFrame {
  std::int64_t step = 0;
  double time = 0;
  Box box;
  double to_angstrom = 1;      ///< of lengths: 10 in SI scenes; 1 in reduced units, which stay as they are
  std::vector<Vec3> positions; ///< in the box
  std::vector<Vec3> velocities;
  /// Further quantities, one value a particle, by names that carry their unit; the same names in every frame.
  std::vector<std::pair<std::string, std::vector<double>>> scalars;

  /// Throws PhysicsError that names the quantity and the step when a number is not finite.
  void check() const;
};

} // namespace mesobridge::workflows
