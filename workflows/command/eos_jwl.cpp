#include "fitting/fluid.hpp"
#include "fitting/model_file.hpp"
#include "fitting/published_jwl.hpp"
#include "fitting/shock_relations.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/quantity.hpp"
#include "workflows/text_file.hpp"
#include "workflows/version.hpp"
#include <CLI/CLI.hpp>
#include <charconv>
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

struct JwlOptions {
  std::string A, B, C, rho0, E0, D, P_CJ, T_CJ = "3000 K", m0;
  double R1 = 0, R2 = 0, omega = 0, c_v = 2000;
};

/// Numbers of a set part by more than this where they are misprinted, or of different sets.
constexpr double much = 0.02;

double si(char const* option, std::string const& text, Dimension dimension) {
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size())
    return value;
  try {
    return parse_quantity(text, dimension);
  } catch (InputError const& refused) {
    throw InputError(fmt::format("{} = {}: {}", option, text, refused.what()));
  }
}

fitting::PublishedJwl set_of(JwlOptions const& given) {
  using enum Dimension;
  return {.A = si("--A", given.A, pressure),
          .B = si("--B", given.B, pressure),
          .R_1 = given.R1,
          .R_2 = given.R2,
          .omega = given.omega,
          .rho_0 = si("--rho0", given.rho0, density),
          .E_0 = si("--E0", given.E0, pressure),
          .D = si("--D", given.D, velocity),
          .P_CJ = si("--P-CJ", given.P_CJ, pressure),
          .C = given.C.empty() ? std::nullopt : std::optional(si("--C", given.C, pressure))};
}

fitting::Jwl model_of(fitting::PublishedJwl const& set, JwlOptions const& given) {
  return fitting::Jwl({.Gamma_0 = set.omega,
                       .rho_0 = set.rho_0,
                       .E_0 = set.E_0 / set.rho_0,
                       .D_CJ = set.D,
                       .P_CJ = set.P_CJ,
                       .T_CJ = si("--T-CJ", given.T_CJ, Dimension::temperature),
                       .c_v = given.c_v,
                       .a = set.A,
                       .b = set.B,
                       .R_1 = set.R_1,
                       .R_2 = set.R_2,
                       .m0 = si("--m0", given.m0, Dimension::mass)});
}

/// The detonation that the model itself has, from the explosive's energy.
fitting::Shock own_detonation(fitting::Jwl const& model) {
  auto const& p = model.parameters();
  fitting::Fluid const fluid(model);
  fitting::EosState ahead{};
  ahead.rho = p.rho_0, ahead.e = p.E_0;
  ahead.T = fluid.at_energy(ahead.rho, ahead.e).T; // of the explosion at constant volume: a scale
  return fitting::Hugoniot(ahead, fluid, 0).chapman_jouguet();
}

/// One number of the set beside what the others imply.
void compare(Result& result, Context const& context, char const* key, char const* label, double unit,
             std::optional<double> published, double implied) {
  result.json[fmt::format("{}_implied", key)] = implied;
  if (!published) {
    result.text += fmt::format("{:<15} {:>12} {:>12.6g}\n", label, "", implied / unit);
    return;
  }
  double const apart = implied / *published - 1;
  result.json[key] = *published;
  result.text += fmt::format("{:<10} {:>12.6g} {:>12.6g} {:>+9.2f} %\n", label, *published / unit,
                             implied / unit, 100 * apart);
  if (!(std::abs(apart) <= much))
    context.log->warn(
        "warning: {}: the other numbers imply {:.6g}, {:+.2f} % from {:.6g}: is the set whole, and of one "
        "source?",
        label, implied / unit, 100 * apart, *published / unit);
}

Result jwl(JwlOptions const& given, Context const& context) {
  auto const set = set_of(given);
  auto const implied = fitting::implied_by(set);
  auto const model = model_of(set, given);
  auto const cj = own_detonation(model);
  Result result;
  result.text = fmt::format("{:<15} {:>12} {:>12} {:>11}\n", "", "published", "implied", "apart");
  constexpr double GPa = 1e9;
  compare(result, context, "C_Pa", "C [GPa]", GPa, set.C, implied.C);
  compare(result, context, "E_0_J_m3", "E0 [GJ/m^3]", GPa, set.E_0, implied.E_0);
  compare(result, context, "D_of_slope_m_s", "D, slope [m/s]", 1, set.D, implied.D_of_slope);
  compare(result, context, "D_m_s", "D [m/s]", 1, set.D, cj.v_S);
  compare(result, context, "P_CJ_Pa", "P_CJ [GPa]", GPa, set.P_CJ, cj.behind.P);
  auto const file = context.options.output.value_or("jwl.toml");
  write_text_file(file, fitting::to_toml(fitting::EosModel{
                            .eos = model,
                            .covariance_factor = {},
                            .valid = {},
                            .data_hash = "",
                            .provenance = {{"command", context.command_line()},
                                           {"program", fmt::format("mesobridge {}", version())}},
                            .fitted = {}}));
  result.json["model"] = file.string();
  result.text += file.string();
  return result;
}

void declare(CLI::App& app, JwlOptions& options) {
  auto const text = [&](char const* name, std::string& target, char const* type, char const* what) {
    return app.add_option(name, target, what)->type_name(type);
  };
  text("--A", options.A, "PRESSURE", "\"524.2 GPa\"; a plain number is SI, here as below")->required();
  text("--B", options.B, "PRESSURE", "Of the second exponential")->required();
  app.add_option("--R1", options.R1, "Decay of the first exponential with V")->required();
  app.add_option("--R2", options.R2, "Of the second")->required();
  app.add_option("--omega", options.omega, "Gruneisen coefficient")->required();
  text("--C", options.C, "PRESSURE", "Of the isentrope, to compare with what the others imply");
  text("--rho0", options.rho0, "DENSITY", "Of the explosive")->required();
  text("--E0", options.E0, "PRESSURE", "Energy of detonation per volume: 1 GPa is 1 GJ/m^3, 1 kJ/cm^3")
      ->required();
  text("--D", options.D, "VELOCITY", "Detonation velocity")->required();
  text("--P-CJ", options.P_CJ, "PRESSURE", "Chapman-Jouguet pressure")->required();
  text("--T-CJ", options.T_CJ, "TEMPERATURE",
       "Its temperature, on which no pressure depends (default 3000 K)");
  app.add_option("--c-v", options.c_v, "Heat capacity [J/(kg K)], on which none does either (default 2000)");
  text("--m0", options.m0, "MASS", "Of one molecule of the explosive, \"227 u\"")->required();
  app.description(
      "A JWL model of published numbers. They say more than the equation of state has room for: what "
      "some imply for the others is printed beside them. The model keeps A, B, R1, R2, omega, E0 and "
      "has the state (rho0, D, P_CJ) on its Crussard curve; D and P_CJ of its own are "
      "printed last.");
}

} // namespace

extern Declaration const eos_jwl_command = with_options<JwlOptions, declare, jwl>;

} // namespace mesobridge::workflows
