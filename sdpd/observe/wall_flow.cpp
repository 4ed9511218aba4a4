#include "sdpd/observe/measurement.hpp"

namespace mesobridge::sdpd {
namespace {

constexpr std::array<std::string_view, 2> lower_and_upper{"_lower", "_upper"};
constexpr std::array<std::string_view, 6> vectors_of_both{"_lower_x", "_lower_y", "_lower_z",
                                                          "_upper_x", "_upper_y", "_upper_z"};

bool with_rough_walls(Features const& has) {
  return has.rough_walls;
}
bool with_body_force(Features const& has) {
  return has.body_force;
}

} // namespace

Measurement wall_drag() {
  return {.name = "wall_drag",
          .meaning = "momentum that the friction of each wall has given to the fluid so far",
          .components = vectors_of_both,
          .dimension = Dimension::momentum,
          .exists = with_rough_walls,
          .values = [](System const& system) {
            std::vector<double> values(6);
            for (auto const& wall : system.walls)
              for (int axis = 0; axis < 3; ++axis)
                values[3 * wall.upper + static_cast<std::size_t>(axis)] = component(wall.drag, axis);
            return values;
          }};
}

Measurement wall_heat() {
  return {.name = "wall_heat",
          .meaning = "heat that has come from each wall into the fluid so far",
          .components = lower_and_upper,
          .dimension = Dimension::energy,
          .exists = with_rough_walls,
          .values = [](System const& system) {
            std::vector<double> values(2);
            for (auto const& wall : system.walls)
              values[wall.upper] = wall.heat;
            return values;
          }};
}

Measurement body_work() {
  return {.name = "body_work",
          .meaning = "work that the body force has done on the fluid so far",
          .dimension = Dimension::energy,
          .exists = with_body_force,
          .values = [](System const& system) { return std::vector<double>{system.body_work}; }};
}

} // namespace mesobridge::sdpd
