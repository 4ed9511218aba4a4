#pragma once
#include "md/box.hpp"
#include <array>
#include <optional>

namespace mesobridge::workflows {

/// The box of three edges that lie anyhow, and how vectors are turned into its axes: the first edge along x,
/// the second in the plane of x and y.
struct TurnedBox {
  Box box;
  std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

  Vec3 turned(Vec3 const& v) const { return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)}; }
};

/// Without a value where the edges make no box: one of no length, all in one plane, left-handed.
std::optional<TurnedBox> box_of_edges(Vec3 const& a, Vec3 const& b, Vec3 const& c);

} // namespace mesobridge::workflows
