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
  auto const& [rough, temperature, strength, slide] = face.friction;
  require(any_number.contains(velocity), "velocity of the " + name, velocity, any_number.demand());
  require(not_negative.contains(ramp), "ramp of the " + name, ramp, not_negative.demand());
  require(is_wall(face) || (velocity == 0 && ramp == 0), "velocity of the " + name, velocity,
          "must be 0: only a wall can move");
  require(is_wall(face) || !rough, "friction of the " + name, "there", "only a wall has some");
  require(positive.contains(temperature), "temperature of the " + name, temperature, positive.demand());
  require(positive.contains(strength), "strength of the friction of the " + name, strength,
          positive.demand());
  for (double const v : {slide.x, slide.y, slide.z})
    require(any_number.contains(v) && (rough || v == 0), "velocity along the " + name, v,
            any_number.demand() + ", and 0 without friction");
}

} // namespace

bool has_walls(Faces const& faces) {
  return std::ranges::any_of(faces, [](auto const& pair) { return is_wall(pair[0]) || is_wall(pair[1]); });
}

bool has_rough_walls(Faces const& faces) {
  return std::ranges::any_of(faces,
                             [](auto const& pair) { return pair[0].friction.acts || pair[1].friction.acts; });
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

std::vector<Wall> make_walls(Faces const& faces, Vec3 const& edge, ReducedUnits const& units) {
  std::vector<Wall> walls;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t side = 0; side < 2; ++side)
      if (auto const& [kind, motion, friction] = faces[axis][side]; kind == FaceKind::wall)
        walls.push_back({.axis = static_cast<int>(axis),
                         .upper = side == 1,
                         .start = side == 1 ? component(edge, static_cast<int>(axis)) : 0,
                         .motion = {motion.velocity / units.velocity(), motion.ramp / units.time()},
                         .friction = {friction.acts, friction.temperature / units.temperature,
                                      friction.strength, friction.slide / units.velocity()}});
  return walls;
}

void check(Faces const& faces) {
  int walled = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const& [lower, upper] = faces[axis];
    check(lower, name_of(axis, 0)), check(upper, name_of(axis, 1));
    for (auto const& face : faces[axis])
      if (double const v = component(face.friction.slide, static_cast<int>(axis)); v != 0)
        throw InputError(
            fmt::format("velocity along a face across {} = {:g}: must have no part along {}, where "
                        "only a piston moves",
                        "xyz"[axis], v, "xyz"[axis]));
    if ((lower.kind == FaceKind::periodic) != (upper.kind == FaceKind::periodic))
      throw InputError(fmt::format("the {} and the {}: must be both periodic or neither", name_of(axis, 0),
                                   name_of(axis, 1)));
    walled += is_wall(lower) || is_wall(upper);
  }
  require(walled <= 1, "axes with walls", walled,
          "must be 0 or 1: particles in a corner would need the images of images");
}

} // namespace mesobridge::sdpd
