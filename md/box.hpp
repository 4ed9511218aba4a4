#pragma once
#include "md/vec3.hpp"

namespace mesobridge {

/// A rectangular box, periodic in all directions, with one corner at the origin.
struct Box {
  Vec3 edge;

  double volume() const { return edge.x * edge.y * edge.z; }

  /// The shortest of the periodic images of a separation; |r| must be within one edge of the box.
  Vec3 minimum_image(Vec3 r) const {
    r.x -= edge.x * std::nearbyint(r.x / edge.x);
    r.y -= edge.y * std::nearbyint(r.y / edge.y);
    r.z -= edge.z * std::nearbyint(r.z / edge.z);
    return r;
  }

  /// The image of a position inside [0, edge).
  Vec3 wrap(Vec3 q) const {
    auto fold = [](double value, double length) {
      value -= length * std::floor(value / length);
      return value < length ? value : 0.0; // floor of a tiny negative number can round up to the edge itself
    };
    return {fold(q.x, edge.x), fold(q.y, edge.y), fold(q.z, edge.z)};
  }
};

} // namespace mesobridge
