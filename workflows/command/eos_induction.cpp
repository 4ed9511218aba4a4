#include "fitting/induction.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/detonation_options.hpp"
#include "workflows/eos/kinetics_options.hpp"
#include "workflows/eos/mixture_columns.hpp"
#include "workflows/eos/named_fluid.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct EosInductionOptions {
  ReactionOptions explosive;
  KineticsOptions kinetics;
  std::optional<double> v_P;
};

/// The explosion's times; Frank-Kamenetskii's is none without heat or activation energy.
Columns times(fitting::ThermalExplosion const& explosion) {
  Columns columns{{"induction", "_s", "s", {explosion.time}}};
  if (std::isfinite(explosion.frank_kamenetskii) && explosion.frank_kamenetskii > 0)
    columns.push_back({"frank_kamenetskii", "_s", "s", {explosion.frank_kamenetskii}});
  return columns;
}

void put_explosion(Result& result, Columns const& columns, double rho,
                   fitting::ThermalExplosion const& explosion) {
  tell_first_row(result, columns, false);
  put_first_row(result.json["exploded"], mixture_columns(rho, explosion.end), false);
  result.text += fmt::format("After the explosion: T = {:.6g} K, P = {:.6g} Pa at {:.6g} kg/m^3\n",
                             explosion.end.T, explosion.end.P, rho);
}

Result induction(EosInductionOptions const& options, Context const& context) {
  auto const fluid = options.explosive.fluid(context);
  auto const kinetics = options.kinetics.kinetics(fluid.at_rest.rho);
  Result result;
  result.json = options.explosive.detonation.names();
  if (!options.v_P) {
    auto const& rest = fluid.at_rest;
    auto const explosion = fitting::thermal_explosion(fluid, rest.rho, rest.e, kinetics);
    put_explosion(result, times(explosion), rest.rho, explosion);
    return result;
  }
  require_positive_number("--vp", *options.v_P);
  auto const found = fitting::shock_to_detonation(fluid, *options.v_P, kinetics);
  auto columns = times(found.explosion);
  columns.push_back({"v_S", "_m_s", "m/s", {found.shock.v_S}});
  columns.push_back({"super_detonation", "_m_s", "m/s", {found.super_detonation}});
  columns.push_back({"overtaken_at", "_s", "s", {found.time}});
  columns.push_back({"overtaken_at", "_m", "m", {found.place}});
  put_explosion(result, columns, found.shock.behind.rho, found.explosion);
  put_first_row(result.json["shocked"], shock_columns({found.shock}), false);
  return result;
}

void declare(CLI::App& app, EosInductionOptions& options) {
  options.explosive.declare(app);
  options.kinetics.declare(app);
  app.add_option(
      "--vp", options.v_P,
      "Velocity of a piston (m/s) whose shock heats the explosive. If not given, the state of --rho0 "
      "and --T0 itself explodes");
  app.description(
      "How long a homogeneous explosive takes to explode by itself, at constant volume and without loss of "
      "heat, until nine tenths have reacted; beside it the estimate of Frank-Kamenetskii, of a reactant that "
      "is not used up. With --vp: the shock's state explodes, first at the piston, and the detonation in "
      "the shocked matter overtakes the shock at the time and place `overtaken_at` (velocities in the "
      "laboratory). A simulation whose piston starts suddenly overheats the first particles and ignites "
      "there sooner.");
}

} // namespace

extern Declaration const eos_induction_command = with_options<EosInductionOptions, declare, induction>;

} // namespace mesobridge::workflows
