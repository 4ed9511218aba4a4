#include "workflows/sdpd/measured_report.hpp"
#include "workflows/quantity.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/measured_series.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// "pressure tensor": a name as people write it.
std::string spoken(std::string_view name) {
  std::string text(name);
  std::ranges::replace(text, '_', ' ');
  return text;
}

/// "xx", nothing for a number.
std::string component_of(MeasuredComponent const& one) {
  auto const end = one.of.components[one.component];
  return std::string(end.substr(std::min<std::size_t>(1, end.size())));
}

std::string label_of(MeasuredComponent const& one) {
  auto const component = component_of(one);
  return spoken(one.of.name) + (component.empty() ? "" : " " + component);
}

/// In the scene's units.
std::optional<double> expected(MeasuredComponent const& one, sdpd::SetState const& set,
                               OutputUnits const& units) {
  if (!one.of.expected)
    return std::nullopt;
  auto const reduced = one.of.expected(set)[one.component];
  return reduced ? std::optional(*reduced * units.of(one.of.dimension).first) : std::nullopt;
}

Table table_of(std::vector<MeasuredComponent> const& all, sdpd::SetState const& set, OutputUnits const& units,
               UnitSystem system) {
  Table table{.header = comparison_header(),
              .caption = fmt::format("Means over the {} times at which they were measured, beside what "
                                     "equilibrium at the set state makes of them.",
                                     all.front().values.size())};
  for (auto const& one : all) {
    std::string const unit(system == UnitSystem::SI ? si_unit(one.of.dimension) : "");
    auto const quantity = label_of(one) + (unit.empty() ? "" : " [" + unit + "]");
    auto const reference = expected(one, set, units);
    table.rows.push_back(reference ? comparison_row(quantity, one.mean(), *reference)
                                   : std::vector{quantity, with_error_text(one.mean()), std::string(),
                                                 std::string(), std::string()});
  }
  return table;
}

/// Components of one measurement that are drawn together: three at most, which can be told apart.
constexpr std::size_t most_curves = 3;

Plot plot_of(std::span<MeasuredComponent const> together, std::vector<double> const& time,
             std::string const& time_label, sdpd::SetState const& set, OutputUnits const& units) {
  auto const& first = together.front();
  auto const axis = axis_of(dataset_name(first.of, units));
  auto title = spoken(first.of.name);
  Plot plot{.name = {}, .title = {}, .x = {.label = time_label}, .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = axis.label;
  int colour = 0;
  for (auto const& one : together) {
    if (auto const component = component_of(one); !component.empty())
      title += (colour > 0 ? ", " : " ") + component;
    add_curve_with_mean(panel, label_of(one), time, scaled(one.values, axis.factor),
                        {one.mean().mean * axis.factor, one.mean().se * axis.factor}, colour);
    if (auto const level = expected(one, set, units);
        level && std::ranges::find(panel.level_lines, *level * axis.factor) == panel.level_lines.end())
      panel.level_lines.push_back(*level * axis.factor);
    colour += 2;
  }
  plot.name = drawing_name("series" + title), plot.title = title + " in time";
  return plot;
}

} // namespace

std::optional<Section> measured_section(std::filesystem::path const& run_file, RunResult const& run,
                                        sdpd::SetState const& set) {
  OutputUnits const units(run.settings.units(), run.scene.units);
  Store const store(run_file, Store::Mode::read);
  auto const all = measured_components(store, run.scene, units);
  if (all.empty())
    return std::nullopt;
  auto const time_axis = axis_of("time" + units.time_key);
  auto const time = scaled(measured_times(store, units), time_axis.factor);
  Section section{"Series", {table_of(all, set, units, run.scene.units)}};
  Figure figure{{},
                "Dashes and bands: the mean ± its standard error; thin lines: what equilibrium makes of it."};
  for (auto one = all.begin(); one != all.end();) {
    std::size_t const left = one->of.components.size() - one->component, count = std::min(left, most_curves);
    if (one->component == 0)
      section.content.emplace_back(Paragraph{fmt::format("`{}`: {}.", one->of.name, one->of.meaning)});
    figure.svgs.push_back(draw_svg(plot_of({one, count}, time, time_axis.label, set, units)));
    one += static_cast<std::ptrdiff_t>(count);
  }
  section.content.emplace_back(std::move(figure));
  return section;
}

} // namespace mesobridge::workflows
