#include "fitting/eos/evaluate.hpp"
#include "fitting/valid_range.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/named_fluid.hpp"
#include "workflows/eos_options.hpp"
#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

struct EosEvalOptions {
  EosOptions eos;
  double rho = 0;
  std::optional<double> T, e, s;
};

/// One printed quantity: its key, the key's end in SI, the unit for people.
struct Line {
  std::string key, si_suffix, unit;
  std::optional<double> value;
};

fitting::EosState state_of(fitting::AnyEos const& any, EosEvalOptions const& options) {
  int const given = int{options.T.has_value()} + int{options.e.has_value()} + int{options.s.has_value()};
  require(given == 1, "options --T, --e, --s", given, "exactly one of them must be given");
  require_positive_number("--rho", options.rho);
  if (options.T)
    require_positive_number("--T", *options.T);
  for (auto const& [name, value] : {std::pair{"--e", options.e}, std::pair{"--s", options.s}})
    require(!value || std::isfinite(*value), name, value.value_or(0), "must be finite");
  return std::visit(
      [&](auto const& eos) {
        if (options.T)
          return state_from_temperature(eos, options.rho, *options.T);
        return options.e ? state_from_energy(eos, options.rho, *options.e)
                         : state_from_entropy(eos, options.rho, *options.s);
      },
      any);
}

Result eval(EosEvalOptions const& options, Context const& context) {
  auto const model = options.eos.load();
  auto const state = state_of(model.eos, options);
  bool const reduced = std::visit([](auto const& eos) { return eos.boltzmann() == 1; }, model.eos);
  if (auto const doubt = fitting::extrapolation(model, state.rho, state.T))
    context.log->warn(*doubt);
  std::vector<Line> const lines{
      {"rho", "_kg_m3", "kg/m^3", state.rho},
      {"T", "_K", "K", state.T},
      {"e", "_J_kg", "J/kg", state.e},
      {"P", "_Pa", "Pa", state.P},
      {"s", "_J_kg_K", "J/(kg K)", state.s},
      {"c_v", "_J_kg_K", "J/(kg K)", state.c_v},
      {"sound_speed", "_m_s", "m/s", state.sound_speed},
      {"free_energy", "_J_kg", "J/kg", state.free_energy},
      {"gruneisen", "", "", state.gruneisen},
      {"alpha_r", "", "", state.alpha_r},
  };
  Result result;
  result.json["model"] = options.eos.model;
  for (auto const& line : lines) {
    if (!line.value) // no sound inside the liquid-gas region, no residual energy of models that have no such
                     // part
      continue;
    result.json[line.key + (reduced ? "" : line.si_suffix)] = *line.value;
    result.text += fmt::format("{:<12} {:<24} {}\n", line.key, fmt::format("{:.10g}", *line.value),
                               reduced ? "" : line.unit);
  }
  return result;
}

void declare(CLI::App& app, EosEvalOptions& options) {
  options.eos.declare(app);
  app.add_option("--rho", options.rho, "Density, in the model's units (SI: kg/m^3)")->required();
  app.add_option("--T", options.T, "Temperature (SI: K)");
  app.add_option("--e", options.e, "Instead of --T: energy per mass (SI: J/kg)");
  app.add_option("--s", options.s, "Instead of --T: entropy per mass (SI: J/(kg K))");
}

} // namespace

extern Declaration const eos_eval_command = with_options<EosEvalOptions, declare, eval>;

} // namespace mesobridge::workflows
