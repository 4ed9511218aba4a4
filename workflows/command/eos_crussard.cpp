#include "fitting/isentrope.hpp"
#include "workflows/command/list.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos/detonation_options.hpp"
#include "workflows/eos/shock_options.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct Options {
  DetonationOptions detonation;
  ShockOptions shock;
};

/// The Crussard curve and the reactant's Hugoniot, with the line, the point and the isentrope of the
/// Chapman-Jouguet detonation (thesis, figures 6.2 and 6.12).
Plot crussard_plot(Explosive const& explosive, std::vector<fitting::Shock> const& curve, double P_last) {
  bool const reduced = explosive.product.reduced;
  auto const& crussard = explosive.crussard;
  auto const cj = crussard.chapman_jouguet();
  double const unit = pressure_unit(reduced);
  Plot plot{.name = "crussard",
            .title = plain(fmt::format("Detonation of {}: D = {:.5g}{}", explosive.reactant.name, cj.v_S,
                                       reduced ? "" : " m/s")),
            .x = {.label = density_label(reduced)},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = pressure_label(reduced);
  panel.series.push_back(
      pressure_series("Crussard, " + explosive.product.name, states_behind(curve), reduced));
  auto const reactant = fitting::Hugoniot(explosive.reactant.fluid, explosive.at_rest)
                            .curve(P_last, static_cast<int>(curve.size()));
  panel.series.push_back(
      pressure_series("Hugoniot, " + explosive.reactant.name, states_behind(reactant), reduced));
  fitting::Isentrope const isentrope(explosive.product.fluid, cj.behind);
  std::vector<fitting::EosState> release;
  Series line{.label = "Rayleigh line", .style = SeriesStyle::dashes};
  int const steps = static_cast<int>(curve.size());
  for (int i = 0; i <= steps; ++i) {
    double const rho = crussard.ahead().rho + (cj.behind.rho - crussard.ahead().rho) * i / steps;
    release.push_back(isentrope.at_density(rho));
    line.x.push_back(rho);
    line.y.push_back(crussard.rayleigh_pressure(cj.v_S, rho) / unit);
  }
  panel.series.push_back(std::move(line));
  panel.series.push_back(pressure_series("isentrope", release, reduced));
  panel.series.push_back({.label = "Chapman-Jouguet", .x = {cj.behind.rho}, .y = {cj.behind.P / unit}});
  return plot;
}

Result crussard(Options const& options, Context const& context) {
  if (context.options.output)
    curve_file(*context.options.output);
  auto const explosive = workflows::explosive(options.detonation);
  bool const reduced = explosive.product.reduced;
  auto const asked = options.shock.shock(explosive.crussard);
  Result result;
  result.json = {{"reactant", options.detonation.reactant}, {"product", options.detonation.product}};
  if (asked) {
    auto const columns = shock_columns({*asked});
    put_first_row(result.json, columns, reduced);
    result.text = lines_text(columns, reduced);
  }
  put_first_row(result.json["constant_volume"], state_columns({explosive.crussard.constant_volume_state()}),
                reduced);
  if (!options.shock.P_max && !context.options.output)
    return result;
  auto const curve = options.shock.curve(explosive.crussard, asked);
  auto const columns = shock_columns(curve);
  result.json["curve"] = arrays(columns, reduced);
  write_curve(
      context, result, [&] { return csv_text(columns, reduced); },
      [&] { return crussard_plot(explosive, curve, curve.back().behind.P); });
  if (!asked && !context.options.output)
    result.text = csv_text(columns, reduced);
  return result;
}

} // namespace

Command eos_crussard_command() {
  return {.name = "eos crussard",
          .summary = "Detonation states of an explosive's products (-o FILE.csv, .svg or .html)",
          .example =
              "mesobridge eos crussard --reactant nitromethane --product nitromethane-products --rho0 1104 "
              "--T0 300 --q 4.716e6 --P-max 3e10 -o crussard.svg",
          .declare = [](CLI::App& app) -> Command::Action {
            auto options = std::make_shared<Options>();
            options->detonation.declare(app);
            options->shock.declare(app);
            return [options](Context& context) { return crussard(*options, context); };
          }};
}

} // namespace mesobridge::workflows
