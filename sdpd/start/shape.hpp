#pragma once
#include "md/vec3.hpp"
#include <variant>

namespace mesobridge::sdpd {

/// The part of space with `from` <= q < `to` in every component.
struct Cuboid {
  Vec3 from, to;

  bool contains(Vec3 const& q) const;
  Cuboid bounds() const { return *this; }
};

struct Sphere {
  Vec3 centre;
  double radius;

  bool contains(Vec3 const& q) const { return norm2(q - centre) < radius * radius; }
  Cuboid bounds() const;
};

/// Along an axis, from one of its ends to the other.
struct Cylinder {
  int axis;    ///< 0, 1, 2 for x, y, z
  Vec3 centre; ///< of any of its circles
  double radius;
  double from, to;

  bool contains(Vec3 const& q) const;
  Cuboid bounds() const;
};

using Shape = std::variant<Cuboid, Sphere, Cylinder>;

bool contains(Shape const& shape, Vec3 const& q);

/// The least cuboid that a shape lies in.
Cuboid bounds(Shape const& shape);

/// What two cuboids share; its edges are not positive where they share nothing.
Cuboid intersection(Cuboid const& a, Cuboid const& b);

} // namespace mesobridge::sdpd
