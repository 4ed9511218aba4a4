#include "workflows/trajectory/edge_vectors.hpp"

namespace mesobridge::workflows {

std::optional<TurnedBox> box_of_edges(Vec3 const& a, Vec3 const& b, Vec3 const& c) {
  constexpr double flat = 1e-9; // volume over that of a rectangular box of such edges
  double const volume = dot(cross(a, b), c);
  if (!(volume > flat * norm(a) * norm(b) * norm(c)) || !std::isfinite(volume))
    return std::nullopt;
  TurnedBox result;
  auto& [x, y, z] = result.axes;
  x = a / norm(a);
  z = cross(a, b) / norm(cross(a, b));
  y = cross(z, x);
  result.box = {.edge = {norm(a), dot(b, y), dot(c, z)}, .xy = dot(b, x), .xz = dot(c, x), .yz = dot(c, y)};
  return result;
}

} // namespace mesobridge::workflows
