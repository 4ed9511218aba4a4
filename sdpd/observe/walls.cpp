#include "sdpd/observe/measurement.hpp"

namespace mesobridge::sdpd {
namespace {

constexpr std::array<std::string_view, 2> lower_and_upper{"_lower", "_upper"};

/// A number of the lower wall and one of the upper, 0 where there is none.
template <class F>
std::vector<double> of_walls(System const& system, F const& f) {
  std::vector<double> values(2);
  for (auto const& wall : system.walls)
    values[wall.upper] = f(wall);
  return values;
}

} // namespace

Measurement wall_pressure() {
  return {.name = "wall_pressure",
          .meaning = "force per area that pushes each wall out of the fluid, without that of its motion",
          .components = lower_and_upper,
          .dimension = Dimension::pressure,
          .exists = with_walls,
          .values = [](System const& system) {
            return of_walls(system, [&](Wall const& wall) {
              double const area = system.box.volume() / component(system.box.edge, wall.axis);
              return (wall.upper ? -1 : 1) * wall.force / area;
            });
          }};
}

Measurement wall_work() {
  return {.name = "wall_work",
          .meaning = "energy that each wall has given to the fluid",
          .components = lower_and_upper,
          .dimension = Dimension::energy,
          .exists = with_walls,
          .values = [](System const& system) {
            return of_walls(system, [](Wall const& wall) { return wall.work; });
          }};
}

} // namespace mesobridge::sdpd
