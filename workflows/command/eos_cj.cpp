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

Result chapman_jouguet(DetonationOptions const& options, Context const& context) {
  auto const explosive = workflows::explosive(options, context);
  bool const reduced = explosive.product.reduced;
  auto const cj = explosive.crussard.chapman_jouguet();
  auto const checks = explosive.crussard.check(cj);
  if (!(checks.neighbours > 0))
    throw PhysicsError(
        fmt::format("the sonic point of the products at density {} is no minimum of D: a neighbour "
                    "is slower by {}",
                    cj.behind.rho, -checks.neighbours));
  warn_outside_data(explosive.product, cj.behind.rho, cj.behind.T, context);
  auto const columns = detonation_columns(cj);
  auto const at_model_pressure = detonation_columns(explosive.from_model_pressure.chapman_jouguet());
  Result result;
  result.json = options.names();
  tell_first_row(result, columns, reduced);
  result.json["q" + std::string(reduced ? "" : "_J_kg")] = options.q;
  result.json["P0" + std::string(reduced ? "" : "_Pa")] = options.P0.value_or(0);
  result.json["tangency_error"] = checks.tangency;
  result.json["least_excess_of_D_nearby"] = checks.neighbours;
  put_first_row(result.json["reactant_model_at_rest"], state_columns({explosive.at_rest}), reduced);
  put_first_row(result.json["from_pressure_of_reactant_model"], at_model_pressure, reduced);
  result.text +=
      fmt::format("From the pressure {:.6g} that the reactant's model has at rest instead of {:.6g}: "
                  "D = {:.6g}\n",
                  explosive.at_rest.P, options.P0.value_or(0), *at_model_pressure[0].values[0]);
  return result;
}

void declare(CLI::App& app, DetonationOptions& options) {
  options.declare(app);
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

extern Declaration const eos_cj_command = with_options<DetonationOptions, declare, chapman_jouguet>;

} // namespace mesobridge::workflows
