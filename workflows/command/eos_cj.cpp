#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/columns.hpp"
#include "workflows/eos/detonation_options.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

/// The quantities of a detonation: D is what a shock calls v_S.
Columns detonation_columns(fitting::Shock const& cj) {
  auto columns = shock_columns({cj});
  std::swap(columns[0], columns[1]);
  columns[0].key = "D";
  return columns;
}

struct CjOptions : DetonationOptions {
  /// Of the explosive at rest, by the products' model: then no model of the explosive is needed.
  std::optional<double> e0;
  CLI::Option *of_reactant = nullptr, *of_T0 = nullptr, *of_q = nullptr;
};

/// The detonation with what its shock relations were asked for, and the checks of both.
Result told(fitting::Hugoniot const& crussard, NamedFluid const& product, Json names,
            Context const& context) {
  auto const cj = crussard.chapman_jouguet();
  auto const checks = crussard.check(cj);
  if (!(checks.neighbours > 0))
    throw PhysicsError(
        fmt::format("the sonic point of the products at density {} is no minimum of D: a neighbour "
                    "is slower by {}",
                    cj.behind.rho, -checks.neighbours));
  warn_outside_data(product, cj.behind.rho, cj.behind.T, context);
  Result result{.json = std::move(names)};
  tell_first_row(result, detonation_columns(cj), product.reduced);
  result.json["tangency_error"] = checks.tangency;
  result.json["least_excess_of_D_nearby"] = checks.neighbours;
  return result;
}

std::string unit_key(NamedFluid const& fluid, char const* unit) {
  return fluid.reduced ? "" : unit;
}

Result from_energy(CjOptions const& options, Context const& context) {
  auto const product = load_fluid(options.product);
  require_positive_number("--rho0", options.initial.rho0);
  double const P0 = options.P0.value_or(0);
  require(std::isfinite(P0), "--P0", P0, "must be finite");
  require(std::isfinite(*options.e0), "--e0", *options.e0, "must be finite");
  fitting::EosState ahead{};
  ahead.rho = options.initial.rho0, ahead.e = *options.e0, ahead.P = P0;
  ahead.T = product.fluid.at_energy(ahead.rho, ahead.e).T; // of the explosion at constant volume: a scale
  require(
      ahead.T > 0, "--e0", ahead.e,
      fmt::format("must be above the energy that the products have at T = 0 and density {:g}", ahead.rho));
  auto result = told({ahead, product.fluid, 0}, product, {{"product", options.product}}, context);
  result.json["e0" + unit_key(product, "_J_kg")] = ahead.e;
  result.json["P0" + unit_key(product, "_Pa")] = P0;
  return result;
}

Result chapman_jouguet(CjOptions const& options, Context const& context) {
  if (options.e0)
    return from_energy(options, context);
  for (auto const* const option : {options.of_reactant, options.of_T0, options.of_q})
    if (option->count() == 0)
      throw InputError(fmt::format("eos cj: {} is required, or --e0 in place of --reactant, --T0 and --q",
                                   option->get_name()));
  auto const explosive = workflows::explosive(options, context);
  bool const reduced = explosive.product.reduced;
  auto result = told(explosive.crussard, explosive.product, options.names(), context);
  auto const at_model_pressure = detonation_columns(explosive.from_model_pressure.chapman_jouguet());
  result.json["q" + unit_key(explosive.product, "_J_kg")] = options.q;
  result.json["P0" + unit_key(explosive.product, "_Pa")] = options.P0.value_or(0);
  put_first_row(result.json["reactant_model_at_rest"], state_columns({explosive.at_rest}), reduced);
  put_first_row(result.json["from_pressure_of_reactant_model"], at_model_pressure, reduced);
  result.text +=
      fmt::format("From the pressure {:.6g} that the reactant's model has at rest instead of {:.6g}: "
                  "D = {:.6g}\n",
                  explosive.at_rest.P, options.P0.value_or(0), *at_model_pressure[0].values[0]);
  return result;
}

void declare(CLI::App& app, CjOptions& options) {
  options.declare(app);
  options.of_reactant = app.get_option("--reactant")->required(false);
  options.of_T0 = app.get_option("--T0")->required(false);
  options.of_q = app.get_option("--q")->required(false);
  app.add_option(
         "--e0", options.e0,
         "Energy per mass of the explosive at rest by the zero of the products' model (SI: J/kg), such as "
         "E_0/rho_0 of published JWL sets; in place of --reactant, --T0 and --q")
      ->excludes(options.of_reactant)
      ->excludes(options.of_T0)
      ->excludes(options.of_q);
  app.description(
      "The Chapman-Jouguet detonation: the slowest one, whose Rayleigh line touches the Crussard curve and "
      "whose products leave the front at their speed of sound. Solved from the sonic condition; the "
      "tangency and the minimum of D are checked.\n\n"
      "About nitromethane: from 1104 kg/m^3, 300 K with q = 4.716e6 J/kg (4.78e-19 J a molecule, the "
      "exothermicity that the thesis prints) D is 6757 m/s. The thesis quotes 6620 m/s as the hydrodynamic "
      "prediction; its own equations give that for q = 3.52e6 J/kg, and it does not say which heat it took. "
      "The JWL model of the products was calibrated with the heat of reaction inside its zero of "
      "energy: with --q 0 from 1128 kg/m^3 it returns its calibration, 6280 m/s, so that any q > 0 "
      "counts heat on top of that.");
}

} // namespace

extern Declaration const eos_cj_command = with_options<CjOptions, declare, chapman_jouguet>;

} // namespace mesobridge::workflows
