#include "fitting/isentrope.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos/named_fluid.hpp"
#include "workflows/interrupt.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct EosIsentropeOptions {
  EosOptions eos;
  InitialState initial;
  std::optional<double> rho, P;
  int points = 60;
};

/// States at densities in geometric progression, and the velocity that matter gains on the way.
Columns along(fitting::Isentrope const& isentrope, fitting::EosState const& to, int points) {
  auto const& from = isentrope.from();
  std::vector<fitting::EosState> states;
  Column velocity{"velocity_change", "_m_s", "m/s", {}};
  for (int i = 0; i <= points; ++i) {
    throw_if_interrupted();
    double const rho = i == points ? to.rho : from.rho * std::pow(to.rho / from.rho, double(i) / points);
    states.push_back(isentrope.at_density(rho));
    velocity.values.push_back(isentrope.velocity_change(from.rho, rho));
  }
  auto columns = state_columns(states);
  columns.push_back(std::move(velocity));
  return columns;
}

Columns last_row(Columns columns) {
  for (auto& c : columns)
    c.values = {c.values.back()};
  return columns;
}

Plot isentrope_plot(NamedFluid const& model, Columns const& columns) {
  Plot plot{.name = "isentrope",
            .title = plain("Isentrope of " + model.name),
            .x = {.label = density_label(model.reduced)},
            .panels = {Panel{.legend = Legend::none}}};
  plot.panels[0].y.label = pressure_label(model.reduced);
  Series series{.style = SeriesStyle::lines};
  for (std::size_t i = 0; i < columns[0].values.size(); ++i) {
    series.x.push_back(*columns[0].values[i]);
    series.y.push_back(*columns[2].values[i] / pressure_unit(model.reduced));
  }
  plot.panels[0].series.push_back(std::move(series));
  return plot;
}

Result isentrope(EosIsentropeOptions const& options, Context const& context) {
  if (context.options.output)
    curve_file(*context.options.output);
  require(options.rho.has_value() != options.P.has_value(), "options --rho, --P",
          int{options.rho.has_value()} + int{options.P.has_value()}, "exactly one of them must be given");
  require(options.points >= 2 && options.points <= 100000, "--points", options.points,
          "must lie between 2 and 100000");
  if (options.rho)
    require_positive_number("--rho", *options.rho);
  auto const model = load_fluid(options.eos);
  fitting::Isentrope const isentrope(model.fluid, options.initial.of(model, context));
  auto const to = options.rho ? isentrope.at_density(*options.rho) : isentrope.at_pressure(*options.P);
  auto const columns = along(isentrope, to, options.points), end = last_row(columns);
  Result result;
  result.json["model"] = options.eos.model;
  tell_first_row(result, end, model.reduced);
  put_first_row(result.json["from"], state_columns({isentrope.from()}), model.reduced);
  put_curve(context, result, columns, model.reduced, [&] { return isentrope_plot(model, columns); });
  return result;
}

void declare(CLI::App& app, EosIsentropeOptions& options) {
  options.eos.declare(app);
  options.initial.declare(app);
  app.add_option("--rho", options.rho, "Density to go to (SI: kg/m^3)");
  app.add_option("--P", options.P, "Instead: pressure to go to (SI: Pa)");
  app.add_option("--points", options.points, "Steps of the curve");
}

} // namespace

extern Declaration const eos_isentrope_command = with_options<EosIsentropeOptions, declare, isentrope>;

} // namespace mesobridge::workflows
