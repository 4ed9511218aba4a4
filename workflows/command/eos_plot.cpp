#include "fitting/isentrope.hpp"
#include "fitting/shock_relations.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos/named_fluid.hpp"
#include "workflows/interrupt.hpp"
#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

struct EosPlotOptions {
  std::vector<std::string> models;
  std::vector<double> isotherms;
  std::optional<double> rho0, T0;
  double rho_min = 0, rho_max = 0;
  int points = 80;
};

/// The points of a curve that lie inside the model.
template <class State>
Series curve(std::string const& label, EosPlotOptions const& options, bool reduced, SeriesStyle style,
             State&& state) {
  std::vector<fitting::EosState> states;
  for (int i = 0; i <= options.points; ++i) {
    throw_if_interrupted();
    double const rho = options.rho_min + (options.rho_max - options.rho_min) * i / options.points;
    try {
      states.push_back(state(rho));
    } catch (PhysicsError const&) {
      // This density is outside the model: the curve ends here.
    }
  }
  auto series = pressure_series(label, states, reduced);
  series.style = style;
  return series;
}

std::vector<Series> curves_of(NamedFluid const& model, EosPlotOptions const& options,
                              Context const& context) {
  std::vector<Series> all;
  for (double const T : options.isotherms)
    all.push_back(curve(fmt::format("{}, T = {:g}{}", model.name, T, model.reduced ? "" : " K"), options,
                        model.reduced, SeriesStyle::lines,
                        [&](double rho) { return model.fluid.at_temperature(rho, T); }));
  if (!options.rho0)
    return all;
  auto const at_rest = InitialState{.rho0 = *options.rho0, .T0 = *options.T0}.of(model, context);
  fitting::Isentrope const isentrope(model.fluid, at_rest);
  all.push_back(curve(model.name + ", isentrope", options, model.reduced, SeriesStyle::dashes,
                      [&](double rho) { return isentrope.at_density(rho); }));
  fitting::Hugoniot const hugoniot(model.fluid, at_rest);
  all.push_back(curve(model.name + ", Hugoniot", options, model.reduced, SeriesStyle::lines,
                      [&](double rho) { return hugoniot.from_density(rho).behind; }));
  return all;
}

Plot eos_plot(std::vector<NamedFluid> const& models, EosPlotOptions const& options, Context const& context) {
  bool const reduced = models.front().reduced;
  auto plot = one_panel("eos", "Equations of state", density_label(reduced), pressure_label(reduced));
  for (auto const& model : models) {
    require_same_units(models.front(), model);
    for (double const T : options.isotherms)
      warn_outside_data(model, {options.rho_min, options.rho_max}, {T, T}, context);
    for (auto& series : curves_of(model, options, context)) {
      if (series.x.empty()) {
        context.log->warn("{}: no density of the range lies inside the model", series.label);
        continue;
      }
      plot.panels[0].series.push_back(std::move(series));
    }
  }
  return plot;
}

void validate(EosPlotOptions const& options, Context const& context) {
  require(context.options.output.has_value(), "-o", "", "a file must be given");
  require(curve_file(*context.options.output) != CurveFile::csv, "-o", context.options.output->string(),
          "must end in .svg or .html (`eos table` writes numbers)");
  require_positive_number("--rho-min", options.rho_min);
  require(options.rho_max > options.rho_min && std::isfinite(options.rho_max), "--rho-max", options.rho_max,
          "must exceed --rho-min");
  require(options.points >= 2 && options.points <= 100000, "--points", options.points,
          "must lie between 2 and 100000");
  require(options.rho0.has_value() == options.T0.has_value(), "options --rho0, --T0",
          int{options.rho0.has_value()} + int{options.T0.has_value()}, "both or none must be given");
  require(options.rho0 || !options.isotherms.empty(), "curves", 0,
          "give --T for isotherms, or --rho0 and --T0 for the Hugoniot and the isentrope");
  for (double const T : options.isotherms)
    require_positive_number("--T", T);
}

Result plot(EosPlotOptions const& options, Context const& context) {
  validate(options, context);
  std::vector<NamedFluid> models;
  for (auto const& name : options.models)
    models.push_back(load_fluid(name));
  Result result;
  result.json["models"] = options.models;
  auto const drawing = eos_plot(models, options, context);
  result.json["curves"] = drawing.panels[0].series.size();
  write_curve(context, result, {}, [&] { return drawing; });
  return result;
}

void declare(CLI::App& app, EosPlotOptions& options) {
  app.add_option("--model", options.models, "Names of `eos list`, or models' files")
      ->required()
      ->type_name("NAME|FILE");
  app.add_option("--T", options.isotherms, "Temperatures of isotherms (SI: K)");
  app.add_option("--rho0", options.rho0, "Hugoniot and isentrope start at this density (SI: kg/m^3)");
  app.add_option("--T0", options.T0, "and this temperature (SI: K)");
  app.add_option("--rho-min", options.rho_min, "Least density of the drawing (SI: kg/m^3)")->required();
  app.add_option("--rho-max", options.rho_max, "Greatest density (SI: kg/m^3)")->required();
  app.add_option("--points", options.points, "Points of a curve");
}

} // namespace

extern Declaration const eos_plot_command = with_options<EosPlotOptions, declare, plot>;

} // namespace mesobridge::workflows
