#include "sdpd/observe/measurement.hpp"

namespace mesobridge::sdpd {
namespace {

constexpr std::array<std::string_view, 2> lower_and_upper{"_lower", "_upper"};
constexpr std::array<std::string_view, 6> vectors_of_both{"_lower_x", "_lower_y", "_lower_z",
                                                          "_upper_x", "_upper_y", "_upper_z"};

bool with_rough_walls(Features const& has) {
  return has.rough_walls;
}

/// A number of the lower wall and one of the upper, 0 where there is none; with walls across several axes the
/// sum over the lower and that over the upper ones.
template <class F>
std::vector<double> of_walls(System const& system, F const& f) {
  std::vector<double> values(2);
  for (auto const& wall : system.walls)
    values[wall.upper] += f(wall);
  return values;
}

/// Of a wall now: a piston makes the walls beside it smaller.
double area_of(System const& system, Wall const& wall) {
  bool const moves = std::ranges::any_of(
      system.walls, [&](Wall const& other) { return other.axis == wall.axis && other.motion.moves(); });
  return (moves ? system.box.volume() : system.volume()) / component(system.box.edge, wall.axis);
}

/// What the walls have given so far.
template <double Wall::*energy>
Measurement energy_of_both(std::string_view name, std::string_view meaning, bool (*exists)(Features const&)) {
  return {.name = name,
          .meaning = meaning,
          .components = lower_and_upper,
          .dimension = Dimension::energy,
          .exists = exists,
          .values = [](System const& system) {
            return of_walls(system, [](Wall const& wall) { return wall.*energy; });
          }};
}

} // namespace

Measurement wall_pressure() {
  return {.name = "wall_pressure",
          .meaning =
              "force per area that pushes each wall out of the fluid, without that of its motion; with "
              "walls across several axes a mean over the lower and one over the upper ones",
          .components = lower_and_upper,
          .dimension = Dimension::pressure,
          .exists = with_walls,
          .values = [](System const& system) {
            auto const area = of_walls(system, [&](Wall const& wall) { return area_of(system, wall); });
            return of_walls(system, [&](Wall const& wall) {
              return (wall.upper ? -1 : 1) * wall.force / area[wall.upper];
            });
          }};
}

Measurement wall_work() {
  return energy_of_both<&Wall::work>(
      "wall_work", "energy that the lower and the upper walls have given to the fluid", with_walls);
}

Measurement wall_drag() {
  return {.name = "wall_drag",
          .meaning =
              "momentum that the friction of the lower and the upper walls has given to the fluid so far",
          .components = vectors_of_both,
          .dimension = Dimension::momentum,
          .exists = with_rough_walls,
          .values = [](System const& system) {
            std::vector<double> values(6);
            for (auto const& wall : system.walls)
              for (int axis = 0; axis < 3; ++axis)
                values[3 * wall.upper + static_cast<std::size_t>(axis)] += component(wall.drag, axis);
            return values;
          }};
}

Measurement wall_heat() {
  return energy_of_both<&Wall::heat>(
      "wall_heat", "heat that has come from the lower and the upper walls into the fluid so far",
      with_rough_walls);
}

} // namespace mesobridge::sdpd
