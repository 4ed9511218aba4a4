#include "sdpd/start/shape.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

bool Cuboid::contains(Vec3 const& q) const {
  return q.x >= from.x && q.x < to.x && q.y >= from.y && q.y < to.y && q.z >= from.z && q.z < to.z;
}

Cuboid Sphere::bounds() const {
  Vec3 const reach{radius, radius, radius};
  return {centre - reach, centre + reach};
}

bool Cylinder::contains(Vec3 const& q) const {
  Vec3 off = q - centre;
  component(off, axis) = 0;
  return norm2(off) < radius * radius && component(q, axis) >= from && component(q, axis) < to;
}

Cuboid Cylinder::bounds() const {
  Cuboid cuboid = Sphere{centre, radius}.bounds();
  component(cuboid.from, axis) = from, component(cuboid.to, axis) = to;
  return cuboid;
}

bool contains(Shape const& shape, Vec3 const& q) {
  return std::visit([&](auto const& of) { return of.contains(q); }, shape);
}

Cuboid bounds(Shape const& shape) {
  return std::visit([](auto const& of) { return of.bounds(); }, shape);
}

Cuboid intersection(Cuboid const& a, Cuboid const& b) {
  Cuboid both;
  for (int axis = 0; axis < 3; ++axis) {
    component(both.from, axis) = std::max(component(a.from, axis), component(b.from, axis));
    component(both.to, axis) = std::min(component(a.to, axis), component(b.to, axis));
  }
  return both;
}

} // namespace mesobridge::sdpd
