#include "fitting/isentrope.hpp"
#include "workflows/command/options.hpp"
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

/// P over the volume relative to that at rest, in which Rayleigh lines are straight.
Series over_volume(std::string const& label, std::vector<fitting::EosState> const& states, double rho_0,
                   bool reduced) {
  auto series = pressure_series(label, states, reduced);
  for (auto& x : series.x)
    x = rho_0 / x;
  return series;
}

/// The isentrope by which the products expand from the Chapman-Jouguet state to the initial volume.
std::vector<fitting::EosState> release(Explosive const& explosive, fitting::Shock const& cj, int steps) {
  fitting::Isentrope const isentrope(explosive.product.fluid, cj.behind);
  std::vector<fitting::EosState> states;
  for (int i = 0; i <= steps; ++i)
    states.push_back(isentrope.at_density(cj.ahead.rho + (cj.behind.rho - cj.ahead.rho) * i / steps));
  return states;
}

/// The Crussard curve and the reactant's Hugoniot, with the line, the point and the isentrope of the
/// Chapman-Jouguet detonation (thesis, figures 6.2 and 6.12).
Plot crussard_plot(Explosive const& explosive, std::vector<fitting::Shock> const& curve) {
  bool const reduced = explosive.product.reduced;
  auto const& crussard = explosive.crussard;
  auto const cj = crussard.chapman_jouguet();
  double const rho_0 = cj.ahead.rho, unit = pressure_unit(reduced);
  int const points = static_cast<int>(curve.size());
  auto products = states_behind(curve);
  products.insert(products.begin(), crussard.constant_volume_state());
  auto const P_last = products.back().P;
  auto reactant =
      states_behind(fitting::Hugoniot(explosive.reactant.fluid, explosive.at_rest).curve(P_last, points));
  reactant.insert(reactant.begin(), explosive.at_rest);
  Plot plot{.name = "crussard",
            .title = plain(fmt::format("Detonation of {}: D = {:.5g}{}", explosive.reactant.name, cj.v_S,
                                       reduced ? "" : " m/s")),
            .x = {.label = "rho_0/rho"},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = pressure_label(reduced);
  panel.series = {
      over_volume("Crussard, " + explosive.product.name, products, rho_0, reduced),
      over_volume("Hugoniot, " + explosive.reactant.name, reactant, rho_0, reduced),
      Series{.label = "Rayleigh line",
             .x = {1, rho_0 / cj.behind.rho},
             .y = {cj.ahead.P / unit, cj.behind.P / unit},
             .style = SeriesStyle::dashes},
      over_volume("isentrope", release(explosive, cj, points), rho_0, reduced),
      Series{.label = "Chapman-Jouguet", .x = {rho_0 / cj.behind.rho}, .y = {cj.behind.P / unit}},
  };
  return plot;
}

Result crussard(Options const& options, Context const& context) {
  if (context.options.output)
    curve_file(*context.options.output);
  auto const explosive = workflows::explosive(options.detonation, context);
  bool const reduced = explosive.product.reduced;
  auto const asked = options.shock.shock(explosive.crussard);
  Result result;
  result.json = {{"reactant", options.detonation.reactant}, {"product", options.detonation.product}};
  if (asked) {
    warn_outside_data(explosive.product, asked->behind.rho, asked->behind.T, context);
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
      [&] { return crussard_plot(explosive, curve); });
  if (!asked && !context.options.output)
    result.text = csv_text(columns, reduced);
  return result;
}

void declare(CLI::App& app, Options& options) {
  options.detonation.declare(app);
  options.shock.declare(app);
}

} // namespace

Command::Action eos_crussard_command(CLI::App& app) {
  return with_options(app, declare, crussard);
}

} // namespace mesobridge::workflows
