#include "workflows/sdpd/space_time.hpp"
#include "workflows/report/colour_map.hpp"
#include "workflows/sdpd/profile_rows.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include <algorithm>
#include <limits>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t least_profiles = 8, most_rows = 240;

struct Shown {
  std::string quantity, key;
  std::size_t components = 1, component = 0;
};

/// Quantities that say most about what flows.
std::vector<Shown> shown(Scene const& scene, OutputUnits const& units) {
  auto const along = static_cast<std::size_t>(scene.profile.axis[0] - 'x');
  return {{"rho", units.density_key},
          {"velocity", units.velocity_key, 3, along},
          {"P", units.pressure_key},
          {"T_int", units.temperature_key},
          {"progress", ""}};
}

/// Every k-th row, so that at most `most_rows` are left.
template <class Row>
std::vector<Row> thinned_rows(std::vector<Row> const& rows) {
  std::size_t const step = (rows.size() + most_rows - 1) / most_rows;
  std::vector<Row> kept;
  for (std::size_t k = 0; k < rows.size(); k += step)
    kept.push_back(rows[k]);
  return kept;
}

/// Slices without particles have no value.
void leave_out_empty(std::vector<std::vector<double>>& rows, std::vector<std::int64_t> const& number) {
  std::size_t k = 0;
  for (auto& row : rows)
    for (double& value : row)
      if (number.at(k++) == 0)
        value = std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::vector<std::string> space_time_pictures(Store const& store, Scene const& scene, OutputUnits const& units,
                                             std::string const& of,
                                             std::vector<std::string> const& quantities) {
  if (scene.profile.every == 0)
    return {};
  auto const time = store.read_doubles("profile/time" + units.time_key);
  auto const place = store.read_doubles("profile/position" + units.length_key);
  if (time.size() < least_profiles || place.size() < 2)
    return {};
  auto const number = store.read_integers("profile/number");
  auto const x = axis_of(scene.profile.axis + units.length_key), t = axis_of("time" + units.time_key);
  std::vector<std::string> pictures;
  for (auto const& [quantity, key, components, component] : shown(scene, units)) {
    bool const wanted = quantities.empty() || std::ranges::find(quantities, quantity) != quantities.end();
    if (!wanted || !store.contains("profile/" + quantity + key))
      continue;
    auto rows = profile_rows(store, quantity + key, place.size(), components, component);
    leave_out_empty(rows, number);
    auto const colour = axis_of(quantity + key);
    for (auto& row : rows)
      row = scaled(row, colour.factor);
    pictures.push_back(
        draw_svg(ColourMap{.name = drawing_name("spacetime" + quantity + of),
                           .title = plain(quantity) + (of.empty() ? " in space and time" : ", " + of),
                           .x_label = x.label,
                           .y_label = t.label,
                           .colour_label = colour.label,
                           .x = scaled(place, x.factor),
                           .y = thinned_rows(scaled(time, t.factor)),
                           .values = thinned_rows(rows)}));
  }
  return pictures;
}

std::optional<Section> space_time_section(Store const& store, Scene const& scene, OutputUnits const& units) {
  Figure figure{
      space_time_pictures(store, scene, units),
      "Profiles of the run over time, each slice a mean over its particles; white where there are none."};
  if (figure.svgs.empty())
    return std::nullopt;
  return Section{"Space and time", {std::move(figure)}};
}

} // namespace mesobridge::workflows
