#include "fitting/taylor_wave.hpp"
#include "workflows/eos/detonation_view.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/detonation.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// One quantity over the distance from the front, with the line of the zone's theory.
std::string in_the_frame(std::string const& quantity, std::string const& key, DetonationOfRun const& found,
                         std::vector<cg::Estimate> const& values, double (*exact)(fitting::ZonePoint const&),
                         OutputUnits const& units) {
  auto const x = axis_of("z" + units.length_key), y = axis_of(quantity + key);
  auto plot = one_panel(drawing_name("detonation" + quantity), quantity + " in the frame of the front",
                        "distance from the front" + x.label.substr(1), y.label);
  Series ours{
      .label = "particles", .x = scaled(found.measured.profile.depth, x.factor), .y = {}, .y_error = {}};
  for (auto const& value : values)
    ours.y.push_back(value.mean * y.factor), ours.y_error.push_back(value.se * y.factor);
  plot.panels[0].series.push_back(std::move(ours));
  Series theory{.label = "zone by ZND", .style = SeriesStyle::lines};
  double const farthest = -found.measured.profile.depth.front();
  for (auto const& point : found.theory.zone)
    if (point.x < farthest)
      theory.x.push_back(-point.x * x.factor), theory.y.push_back(exact(point) * y.factor);
  if (!theory.x.empty())
    plot.panels[0].series.push_back(std::move(theory));
  return draw_svg(plot);
}

std::string way_of_the_front(DetonationOfRun const& found, OutputUnits const& units) {
  auto const x = axis_of("time" + units.time_key), y = axis_of("front" + units.length_key);
  auto plot = one_panel(drawing_name("detonationfront"), "The way of the front", x.label, y.label);
  plot.panels[0].series = {{.label = "",
                            .x = scaled(found.measured.times, x.factor),
                            .y = scaled(found.measured.fronts, y.factor),
                            .y_error = {}}};
  return draw_svg(plot);
}

std::string pressure_and_volume(DetonationOfRun const& found, Scene const& scene) {
  auto const& fluid = found.theory.fluid;
  auto const view = view_of(fluid, scene.fluid.eos, *scene.reaction.product, scene.units == UnitSystem::lj);
  double highest =
      found.theory.zone.empty() ? found.theory.chapman_jouguet.behind.P : found.theory.spike().state.P;
  for (double const P : found.P)
    highest = std::max(highest, P);
  return draw_svg(detonation_plot(view, 1.1 * highest, 120,
                                  {{.label = "slices of the run", .rho = found.rho, .P = found.P}}));
}

/// Whether a rarefaction follows, since the wall that the wave has left is slower than the products.
bool is_released(DetonationOfRun const& found) {
  return found.wall && *found.wall < 0.98 * found.theory.chapman_jouguet.v_P;
}

/// The rarefaction behind, which grows with the way of the front, so that the instants lie on each other.
std::string release_drawing(DetonationOfRun const& found, OutputUnits const& units) {
  auto const y = axis_of("P" + units.pressure_key), t = axis_of("time" + units.time_key);
  Plot plot{.name = "release",
            .title = "Self-similar rarefaction",
            .x = {.label = "way, 1 at the end of the zone", .min = 0},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = y.label;
  for (auto const& at : found.release)
    panel.series.push_back({.label = fmt::format("{} = {}", t.label, number_text(at.time * t.factor, 3)),
                            .x = at.place,
                            .y = scaled(at.P, y.factor),
                            .y_error = {}});
  try {
    Series exact{.label = "Taylor", .x = {0}, .style = SeriesStyle::lines};
    auto const wave = fitting::taylor_wave(fitting::Fluid(found.theory.fluid.mixture.product().eos()),
                                           found.theory.chapman_jouguet, *found.wall, 60);
    exact.y.push_back(wave.back().state.P * y.factor);
    for (auto at = wave.rbegin(); at != wave.rend(); ++at)
      exact.x.push_back(at->place), exact.y.push_back(at->state.P * y.factor);
    panel.series.push_back(std::move(exact));
  } catch (PhysicsError const&) { // products without a state at rest have no such wave
  }
  return draw_svg(plot);
}

Table comparison(DetonationOfRun const& found, OutputUnits const& units) {
  bool const si = !units.length_key.empty();
  Table table{
      .header = comparison_header(),
      .caption =
          "The front from blocks of frames, beside the velocity of Chapman and Jouguet with the same "
          "models; the zone (0.02 <= mean progress <= 0.98) beside that of Zel'dovich, von Neumann and "
          "Doering for the same kinetics, which has neither viscosity nor particles."};
  table.rows.push_back(comparison_row(si ? "velocity of the detonation [m/s]" : "velocity of the detonation",
                                      found.measured.D, found.theory.chapman_jouguet.v_S));
  if (!found.theory.zone.empty())
    table.rows.push_back(
        comparison_row(si ? "length of the reaction zone [m]" : "length of the reaction zone",
                       found.measured.zone, found.theory.zone_length()));
  return table;
}

} // namespace

Section detonation_section(DetonationOfRun const& found, Scene const& scene, OutputUnits const& units) {
  using Point = fitting::ZonePoint const&;
  auto const& profile = found.measured.profile;
  Section section{"Detonation", {comparison(found, units)}};
  if (!found.is_steady())
    section.content.emplace_back(
        Paragraph{fmt::format("The wave is not steady: from the first half of these frames to the second its "
                              "velocity changes by {} {}.",
                              with_error_text(found.measured.change_of_D),
                              units.length_key.empty() ? "in units of velocity" : "m/s")});
  section.content.emplace_back(Figure{{way_of_the_front(found, units), pressure_and_volume(found, scene)},
                                      "Left: the last crossing, from ahead, of half the velocity that the "
                                      "products of Chapman and Jouguet have. "
                                      "Right: pressure over volume, with the slices between the beginning of "
                                      "the wave and its front at the last of "
                                      "these instants."});
  if (profile.depth.empty()) // of too few frames
    return section;
  if (is_released(found))
    section.content.emplace_back(Figure{{release_drawing(found, units)},
                                        "Pressure over the way that the wave has come, at four instants; the "
                                        "line is G. I. Taylor's wave behind "
                                        "a detonation that began at the same wall."});
  section.content.emplace_back(
      Figure{{in_the_frame(
                  "P", units.pressure_key, found, profile.P, [](Point at) { return at.state.P; }, units),
              in_the_frame(
                  "rho", units.density_key, found, profile.rho, [](Point at) { return at.rho; }, units),
              in_the_frame(
                  "T", units.temperature_key, found, profile.T, [](Point at) { return at.state.T; }, units),
              in_the_frame(
                  "progress", "", found, profile.progress, [](Point at) { return at.lambda; }, units)},
             "Means over the frames with their standard errors. Lines: the zone by ZND; a fluid of particles "
             "spreads its "
             "front over the reach of a particle and over what its viscosity asks for."});
  return section;
}

} // namespace mesobridge::workflows
