#include "sdpd/boundary/face.hpp"
#include "md/number_range.hpp"

namespace mesobridge::sdpd {
namespace {

std::string name_of(std::size_t axis, std::size_t side) {
  return fmt::format("{} face across {}", side == 0 ? "lower" : "upper", "xyz"[axis]);
}

bool is_wall(Face const& face) {
  return face.kind == FaceKind::wall;
}

void check(Face const& face, std::string const& name) {
  auto const& [velocity, ramp] = face.motion;
  require(any_number.contains(velocity), "velocity of the " + name, velocity, any_number.demand());
  require(not_negative.contains(ramp), "ramp of the " + name, ramp, not_negative.demand());
  require(is_wall(face) || (velocity == 0 && ramp == 0), "velocity of the " + name, velocity,
          "must be 0: only a wall can move");
}

} // namespace

bool has_walls(Faces const& faces) {
  return std::ranges::any_of(faces, [](auto const& pair) { return is_wall(pair[0]) || is_wall(pair[1]); });
}

std::array<bool, 3> periodic_axes(Faces const& faces) {
  std::array<bool, 3> periodic{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    periodic[axis] = faces[axis][0].kind == FaceKind::periodic;
  return periodic;
}

std::array<bool, 3> open_axes(Faces const& faces) {
  std::array<bool, 3> open{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    open[axis] =
        std::ranges::any_of(faces[axis], [](Face const& face) { return face.kind == FaceKind::open; });
  return open;
}

std::vector<Wall> make_walls(Faces const& faces, Vec3 const& edge, double velocity_unit, double time_unit) {
  std::vector<Wall> walls;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t side = 0; side < 2; ++side)
      if (auto const& [kind, motion] = faces[axis][side]; kind == FaceKind::wall)
        walls.push_back({.axis = static_cast<int>(axis),
                         .upper = side == 1,
                         .start = side == 1 ? component(edge, static_cast<int>(axis)) : 0,
                         .motion = {motion.velocity / velocity_unit, motion.ramp / time_unit}});
  return walls;
}

void check(Faces const& faces) {
  int walled = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const& [lower, upper] = faces[axis];
    check(lower, name_of(axis, 0)), check(upper, name_of(axis, 1));
    if ((lower.kind == FaceKind::periodic) != (upper.kind == FaceKind::periodic))
      throw InputError(fmt::format("the {} and the {}: must be both periodic or neither", name_of(axis, 0),
                                   name_of(axis, 1)));
    walled += is_wall(lower) || is_wall(upper);
  }
  require(walled <= 1, "axes with walls", walled,
          "must be 0 or 1: particles in a corner would need the images of images");
}

} // namespace mesobridge::sdpd
