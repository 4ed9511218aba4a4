#include "sdpd/method/mean_field_viscosity.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/flow.hpp"
#include "workflows/sdpd/run_plots.hpp"

namespace mesobridge::workflows {
namespace {

std::string with_unit(std::string const& quantity, std::string const& unit, bool si) {
  return si ? quantity + " [" + unit + "]" : quantity;
}

Plot velocities(FlowOfRun const& flow, RunResult const& run) {
  OutputUnits const units(run.settings.units(), run.scene.units);
  auto const x = axis_of(run.scene.profile.axis + units.length_key),
             y = axis_of("velocity" + units.velocity_key);
  Plot plot{.name = "flow", .title = "Velocity along the flow", .x = {.label = x.label}, .panels = {Panel{}}};
  auto const at = scaled(flow.position, x.factor);
  Series measured{.label = "measured", .x = at};
  for (auto const& v : flow.velocity)
    measured.y.push_back(v.mean * y.factor), measured.y_error.push_back(v.se * y.factor);
  plot.panels[0].y.label = y.label;
  plot.panels[0].series = {std::move(measured),
                           {.label = "exact, without slip",
                            .x = at,
                            .y = scaled(flow.exact, y.factor),
                            .y_error = {},
                            .style = SeriesStyle::lines}};
  return plot;
}

} // namespace

Section flow_section(FlowOfRun const& flow, RunResult const& run) {
  bool const si = run.scene.units == UnitSystem::SI;
  bool const realised = run.scene.transport.eta_means == "realised";
  Table table{.header = comparison_header(),
              .caption = realised
                             ? "The steady flow, beside the viscosity that was asked for of the fluid that "
                               "flows (sdpd/README.md, Eqs. (S94), (S95))."
                             : "The steady flow, beside the viscosity that friction and motion have in a "
                               "fluid without structure (sdpd/README.md, Eq. (S55)); stiff fluids of large "
                               "particles have more."};
  if (flow.sees_stress)
    table.rows.push_back(
        comparison_row(with_unit("viscosity", "Pa s", si), flow.viscosity,
                       realised ? run.scene.transport.eta : sdpd::mean_field_viscosity(run.settings).sum()));
  if (run.settings.features().densities)
    table.rows.push_back({with_unit(realised ? "viscosity of the pairs" : "viscosity asked for", "Pa s", si),
                          number_text(run.scene.transport.friction(), 4), "", "", ""});
  if (flow.slip_length)
    table.rows.push_back(
        {with_unit("slip length", "m", si), with_error_text(*flow.slip_length), "0", "", ""});
  Figure figure{
      {draw_svg(velocities(flow, run))},
      "Means over the steady part of the run with their standard errors; line: the exact profile of a "
      "fluid of the measured viscosity (of Couette's flow: of any) that does not slip."};
  return {"Flow", {std::move(table), std::move(figure)}};
}

} // namespace mesobridge::workflows
