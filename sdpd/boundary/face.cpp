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

void check(std::vector<MotionRow> const& table, std::string const& name) {
  for (std::size_t k = 0; k < table.size(); ++k) {
    auto const& [time, velocity, way] = table[k];
    require(any_number.contains(velocity), "velocity in the table of the " + name, velocity,
            any_number.demand());
    require(k > 0 ? time > table[k - 1].time && std::isfinite(time) : time == 0,
            "time in the table of the " + name, time,
            k > 0 ? fmt::format("must be > {:g}, that of the row before", table[k - 1].time)
                  : "must be 0 in the first row");
  }
}

void check(Face const& face, std::string const& name) {
  auto const& [velocity, ramp, table] = face.motion;
  auto const& [rough, temperature, strength, slide, slide_ramp, bath] = face.friction;
  require(any_number.contains(velocity), "velocity of the " + name, velocity, any_number.demand());
  require(not_negative.contains(ramp), "ramp of the " + name, ramp, not_negative.demand());
  require(is_wall(face) || (velocity == 0 && ramp == 0), "velocity of the " + name, velocity,
          "must be 0: only a wall can move");
  require(is_wall(face) || table.empty(), "table of the " + name, "there", "only a wall can move");
  require(table.empty() || (velocity == 0 && ramp == 0), "velocity of the " + name, velocity,
          "must be 0 beside a table");
  check(table, name);
  require(is_wall(face) || !rough, "friction of the " + name, "there", "only a wall has some");
  require(positive.contains(temperature), "temperature of the " + name, temperature, positive.demand());
  require(positive.contains(strength), "strength of the friction of the " + name, strength,
          positive.demand());
  for (double const v : {slide.x, slide.y, slide.z})
    require(any_number.contains(v) && (rough || v == 0), "velocity along the " + name, v,
            any_number.demand() + ", and 0 without friction");
  require(not_negative.contains(slide_ramp), "ramp of the velocity along the " + name, slide_ramp,
          not_negative.demand());
  require(bath || rough, "bath of the " + name, "none", "only a wall with friction has one or none");
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

namespace {

WallMotion in_units(WallMotion const& motion, ReducedUnits const& units) {
  auto table = motion.table;
  for (auto& [time, velocity, way] : table)
    time /= units.time(), velocity /= units.velocity();
  auto reduced = motion_by_table(std::move(table));
  reduced.velocity = motion.velocity / units.velocity(), reduced.ramp = motion.ramp / units.time();
  return reduced;
}

WallFriction in_units(WallFriction friction, ReducedUnits const& units) {
  friction.temperature = friction.temperature / units.temperature;
  friction.slide = friction.slide / units.velocity(), friction.slide_ramp /= units.time();
  return friction;
}

} // namespace

std::vector<Wall> make_walls(Faces const& faces, Vec3 const& edge, ReducedUnits const& units) {
  std::vector<Wall> walls;
  std::uint32_t axes = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t side = 0; side < 2; ++side)
      if (auto const& [kind, motion, friction] = faces[axis][side]; kind == FaceKind::wall)
        walls.push_back({.axis = static_cast<int>(axis),
                         .upper = side == 1,
                         .start = side == 1 ? component(edge, static_cast<int>(axis)) : 0,
                         .number = 2 * axes + static_cast<std::uint32_t>(side),
                         .motion = in_units(motion, units),
                         .friction = in_units(friction, units)});
    axes += is_wall(faces[axis][0]) || is_wall(faces[axis][1]);
  }
  return walls;
}

std::vector<WallCorner> make_corners(std::vector<Wall> const& walls) {
  std::vector<WallCorner> corners;
  for (std::size_t a = 0; a < walls.size(); ++a)
    for (std::size_t b = a + 1; b < walls.size(); ++b) {
      if (walls[a].axis == walls[b].axis)
        continue;
      corners.push_back({.walls = {a, b}});
      for (std::size_t c = b + 1; c < walls.size(); ++c)
        if (walls[c].axis != walls[b].axis)
          corners.push_back({.walls = {a, b, c}});
    }
  return corners;
}

void check(Faces const& faces) {
  int moving = 0;
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
    moving += lower.motion.moves() || upper.motion.moves();
  }
  require(moving <= 1, "axes along which walls move", moving, "must be 0 or 1");
}

} // namespace mesobridge::sdpd
