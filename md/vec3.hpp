#pragma once
#include <cmath>

namespace mesobridge {

/// A vector in space: position, momentum, force.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  Vec3& operator+=(Vec3 const& o) {
    x += o.x, y += o.y, z += o.z;
    return *this;
  }
  Vec3& operator-=(Vec3 const& o) {
    x -= o.x, y -= o.y, z -= o.z;
    return *this;
  }
  Vec3& operator*=(double s) {
    x *= s, y *= s, z *= s;
    return *this;
  }
  friend Vec3 operator+(Vec3 a, Vec3 const& b) { return a += b; }
  friend Vec3 operator-(Vec3 a, Vec3 const& b) { return a -= b; }
  friend Vec3 operator-(Vec3 const& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(Vec3 a, double s) { return a *= s; }
  friend Vec3 operator*(double s, Vec3 a) { return a *= s; }
  friend Vec3 operator/(Vec3 a, double s) { return a *= 1 / s; }
  friend bool operator==(Vec3 const&, Vec3 const&) = default;
};

inline double dot(Vec3 const& a, Vec3 const& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 const& a, Vec3 const& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm2(Vec3 const& a) {
  return dot(a, a);
}
/// The component along an axis, 0, 1, 2 for x, y, z.
inline double& component(Vec3& a, int axis) {
  return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}
inline double component(Vec3 const& a, int axis) {
  return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}
inline double norm(Vec3 const& a) {
  return std::sqrt(norm2(a));
}

} // namespace mesobridge
