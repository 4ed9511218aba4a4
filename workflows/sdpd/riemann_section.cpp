#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/riemann_problem.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// One quantity: the slices, and the exact flow as a line.
std::string drawing(std::string const& quantity, std::string const& key, RiemannComparison const& found,
                    std::vector<double> const& ours, std::vector<double> const& exact,
                    OutputUnits const& units, std::string const& name) {
  auto const x = axis_of("z" + units.length_key), y = axis_of(quantity + key);
  auto plot = one_panel(drawing_name("riemann" + name + quantity), quantity + " and the exact solution",
                        "position" + x.label.substr(1), y.label);
  auto const place = scaled(found.place, x.factor);
  plot.panels[0].series = {{.label = "exact",
                            .x = place,
                            .y = scaled(exact, y.factor),
                            .y_error = {},
                            .style = SeriesStyle::lines},
                           {.label = "particles", .x = place, .y = scaled(ours, y.factor), .y_error = {}}};
  return draw_svg(plot);
}

std::vector<double> exact_values(RiemannComparison const& found, double (*of)(fitting::FlowState const&)) {
  std::vector<double> values;
  std::ranges::transform(found.exact, std::back_inserter(values), of);
  return values;
}

} // namespace

Section riemann_section(RiemannComparison const& found, OutputUnits const& units, std::string const& name) {
  using State = fitting::FlowState const&;
  auto const rho = exact_values(found, [](State at) { return at.state.rho; }),
             u = exact_values(found, [](State at) { return at.u; }),
             P = exact_values(found, [](State at) { return at.state.P; }),
             T = exact_values(found, [](State at) { return at.state.T; });
  Table table{.header = {"quantity", "error L1", "of the largest exact value"},
              .caption =
                  "Means of |particles - exact| over the part of the box that its ends have not disturbed."};
  for (auto const& [name, error, exact] : {std::tuple("density", found.rho_error, &rho),
                                           {"velocity", found.u_error, &u},
                                           {"pressure", found.P_error, &P}}) {
    double largest = 0;
    for (double const value : *exact)
      largest = std::max(largest, std::abs(value));
    table.rows.push_back({name, number_text(error, 3), number_text(100 * error / largest, 3) + " %"});
  }
  Figure figure{
      {drawing("rho", units.density_key, found, found.rho, rho, units, name),
       drawing("u", units.velocity_key, found, found.u, u, units, name),
       drawing("P", units.pressure_key, found, found.P, P, units, name),
       drawing("T", units.temperature_key, found, found.T, T, units, name)},
      fmt::format("After {} {}: means over slices of the box, and the exact solution of the Riemann "
                  "problem with the same equation of state, without viscosity.",
                  number_text(found.time, 4), units.time_key.empty() ? "units of time" : "s")};
  return {"Riemann problem", {std::move(figure), std::move(table)}};
}

} // namespace mesobridge::workflows
