#pragma once
#include "md/vec3.hpp"
#include <array>

namespace mesobridge {

/// A rectangular box with one corner at the origin, periodic along all its edges if it does not say
/// otherwise.
struct Box {
  Vec3 edge;
  std::array<bool, 3> periodic{true, true, true};

  double volume() const { return edge.x * edge.y * edge.z; }

  /// The shortest of the periodic images of a separation; |r| must be within one edge of the box.
  Vec3 minimum_image(Vec3 r) const {
    auto nearest = [](double value, double length, bool repeats) {
      return repeats ? value - length * std::nearbyint(value / length) : value;
    };
    return {nearest(r.x, edge.x, periodic[0]), nearest(r.y, edge.y, periodic[1]),
            nearest(r.z, edge.z, periodic[2])};
  }

  /// The image of a position inside [0, edge) along the edges that are periodic.
  Vec3 wrap(Vec3 q) const {
    auto fold = [](double value, double length, bool repeats) {
      if (!repeats)
        return value;
      value -= length * std::floor(value / length);
      return value < length ? value : 0.0; // floor of a tiny negative number can round up to the edge itself
    };
    return {fold(q.x, edge.x, periodic[0]), fold(q.y, edge.y, periodic[1]), fold(q.z, edge.z, periodic[2])};
  }
};

} // namespace mesobridge
