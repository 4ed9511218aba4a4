#include "workflows/sdpd/start_picture.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// The scene's layout, or that of its one fluid.
sdpd::Layout layout_of(sdpd::SimulationSettings const& settings) {
  if (settings.layout)
    return *settings.layout;
  auto const edge = sdpd::box_of(settings).edge;
  return {edge,
          {{.name = "fluid", .shape = sdpd::Cuboid{{}, edge}, .spacing = settings.spacing()}},
          settings.seed};
}

/// Which edge of the box the picture shows to the right, which upwards, and which it looks along.
struct View {
  int right, up, along;
};
View view_of(Vec3 const& edge) {
  std::array<int, 3> axes{2, 0, 1};
  std::ranges::stable_sort(axes, std::greater(), [&](int axis) { return component(edge, axis); });
  return {axes[0], axes[1], axes[2]};
}

/// At most `most` points of a series, evenly taken.
void thin(Series& series, std::size_t most) {
  std::size_t const step = (series.x.size() + most - 1) / most;
  if (step < 2)
    return;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < series.x.size(); k += step, ++kept)
    series.x[kept] = series.x[k], series.y[kept] = series.y[k];
  series.x.resize(kept), series.y.resize(kept);
}

} // namespace

Plot start_picture(Scene const& scene, sdpd::SimulationSettings const& settings) {
  constexpr std::size_t most_points = 3000; // of a region
  auto const layout = layout_of(settings);
  auto const view = view_of(layout.edge());
  OutputUnits const units(settings.units(), scene.units);
  auto const length = axis_of("z" + units.length_key);
  double const unit = units.length * length.factor, middle = 0.5 * component(layout.edge(), view.along);
  Panel panel;
  for (std::size_t r = 0; r < layout.regions().size(); ++r)
    panel.series.push_back(
        {.label = layout.regions()[r].name, .x = {}, .y = {}, .y_error = {}, .colour = static_cast<int>(r)});
  layout.for_each_place([&](Vec3 const& q, std::size_t region) {
    double const depth = (component(q, view.along) - middle) / layout.regions()[region].spacing;
    if (depth < -0.25 || depth >= 0.75) // one layer, whether their number is even or odd
      return;
    panel.series[region].x.push_back(component(q, view.right) * unit);
    panel.series[region].y.push_back(component(q, view.up) * unit);
  });
  for (auto& series : panel.series)
    thin(series, most_points);
  std::erase_if(panel.series, [](Series const& series) { return series.x.empty(); });
  auto const label = [&](int axis) {
    return std::string(1, static_cast<char>('x' + axis)) + length.label.substr(1);
  };
  panel.y.label = label(view.up);
  return {.name = "start",
          .title = "The particles at the start",
          .x = {.label = label(view.right)},
          .panels = {panel}};
}

std::vector<std::string> region_lines(Scene const& scene, sdpd::SimulationSettings const& settings) {
  if (!settings.layout)
    return {};
  auto const& layout = *settings.layout;
  auto const species = settings.reduced_species();
  OutputUnits const units(settings.units(), scene.units);
  std::vector<std::string> lines;
  for (std::size_t r = 0; r < layout.regions().size(); ++r) {
    auto const& region = layout.regions()[r];
    if (region.vacuum) {
      lines.push_back(fmt::format("{}: vacuum", region.name));
      continue;
    }
    double const mass = species.empty() ? 1 : species[region.species].mass;
    double const rho = mass / std::pow(region.spacing, 3) * (1 + layout.excess(r)) * units.density;
    lines.push_back(fmt::format("{}: {} particles, {}{} apart, {}{}", region.name, layout.particles()[r],
                                number_text(region.spacing * units.length, 4),
                                units.length_key.empty() ? "" : " m", number_text(rho, 6),
                                units.density_key.empty() ? "" : " kg/m^3"));
  }
  return lines;
}

} // namespace mesobridge::workflows
