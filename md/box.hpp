#pragma once
#include "md/vec3.hpp"
#include <algorithm>
#include <array>

namespace mesobridge {

/// A box with one corner at the origin, periodic along all its edges if it does not say otherwise. Its edges
/// are (edge.x, 0, 0), (xy, edge.y, 0) and (xz, yz, edge.z), as LAMMPS has them: rectangular without tilts.
struct Box {
  Vec3 edge; ///< of a tilted box the length of the first edge, and how far the others reach along y and z
  std::array<bool, 3> periodic{true, true, true};
  double xy = 0, xz = 0, yz = 0;

  double volume() const { return edge.x * edge.y * edge.z; }
  bool tilted() const { return xy != 0 || xz != 0 || yz != 0; }
  /// Whether the edges are those of the other box within round-off.
  bool is_that(Box const& other) const {
    Vec3 const tilt{xy - other.xy, xz - other.xz, yz - other.yz};
    return norm2(edge - other.edge) + norm2(tilt) < 1e-18 * norm2(other.edge);
  }

  /// What a position is in parts of the three edges.
  Vec3 parts(Vec3 r) const {
    double const c = r.z / edge.z, b = (r.y - yz * c) / edge.y;
    return {(r.x - xy * b - xz * c) / edge.x, b, c};
  }
  /// The position of such parts.
  Vec3 position(Vec3 s) const {
    return {edge.x * s.x + xy * s.y + xz * s.z, edge.y * s.y + yz * s.z, edge.z * s.z};
  }

  /// The distances of opposite faces; of a rectangular box its edges.
  Vec3 widths() const {
    double const of_x = (xy * yz / edge.y - xz) / edge.z, of_y = yz / edge.z;
    return {edge.x / std::sqrt(1 + (xy / edge.y) * (xy / edge.y) + of_x * of_x),
            edge.y / std::sqrt(1 + of_y * of_y), edge.z};
  }
  /// How far a position lies from the planes of the other two edges, for each edge; itself if not tilted.
  Vec3 across(Vec3 const& r) const {
    if (!tilted())
      return r;
    Vec3 const s = parts(r), w = widths();
    return {s.x * w.x, s.y * w.y, s.z * w.z};
  }
  /// The smallest of the distances of opposite faces.
  double narrowest() const {
    Vec3 const w = widths();
    return std::min({w.x, w.y, w.z});
  }

  /// The shortest of the periodic images of a separation; |r| must be within one edge of the box. In a tilted
  /// box it is found if it is shorter than half of the narrowest width: each of its components is then within
  /// half of the edge of its axis, which no other image has (md/README.md, Eq. (M18)).
  Vec3 minimum_image(Vec3 r) const {
    return reduced(r, [](double& value, double length) {
      double const turns = std::nearbyint(value / length);
      value -= length * turns;
      return turns;
    });
  }

  /// The image of a position inside the box along the edges that are periodic: its parts are in [0, 1), of
  /// tilted boxes within round-off.
  Vec3 wrap(Vec3 q) const {
    if (tilted()) {
      Vec3 const s = parts(q);
      return q - position({periodic[0] ? std::floor(s.x) : 0, periodic[1] ? std::floor(s.y) : 0,
                           periodic[2] ? std::floor(s.z) : 0});
    }
    return reduced(q, [](double& value, double length) {
      double const turns = std::floor(value / length);
      value -= length * turns;
      if (!(value < length))
        value = 0; // floor of a tiny negative number can round up to the edge itself
      return turns;
    });
  }

 private:
  /// Without whole edges; `fold` takes them from a component and returns their number.
  template <class Fold>
  Vec3 reduced(Vec3 r, Fold const& fold) const {
    double const c = periodic[2] ? fold(r.z, edge.z) : 0;
    r.y -= yz * c;
    double const b = periodic[1] ? fold(r.y, edge.y) : 0;
    r.x -= xz * c + xy * b;
    if (periodic[0])
      fold(r.x, edge.x);
    return r;
  }
};

} // namespace mesobridge
