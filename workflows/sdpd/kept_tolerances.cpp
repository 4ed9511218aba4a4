#include "workflows/sdpd/kept_tolerances.hpp"
#include "md/error.hpp"
#include "sdpd/method/step_diffusion.hpp"
#include "sdpd/observe/health.hpp"
#include "workflows/scene/driven.hpp"
#include "workflows/scene/tolerance.hpp"
#include <cmath>
#include <sstream>

namespace mesobridge::workflows {
namespace {

/// `unit` ends the keys of numbers that have one.
Json kept(std::string const& text, double wanted, double found, double se, std::string const& unit = "") {
  return {{"tolerance", text},
          {"wanted" + unit, wanted},
          {"found" + unit, found},
          {"found" + unit + "_se", se},
          {"found_over_wanted", found / wanted},
          {"found_over_wanted_se", se / wanted},
          {"fulfilled", found - 2 * se <= wanted}};
}

/// Of the total energy; in scenes that something drives what is missing of the energy that was turned over.
Json kept_drift(RunResult const& result, std::string const& text) {
  if (text.ends_with('%'))
    return kept(text, parse_share(text), std::abs(result.summary.value("energy_balance_error", 0.0)), 0);
  double const time = result.settings.units().time();
  auto const& drift = result.equilibrium.drift;
  return kept(text, parse_rate(text, result.scene.units), std::abs(drift.rate) / time, drift.se / time,
              result.scene.units == UnitSystem::SI ? "_per_s" : "");
}

/// Of the temperatures, which are known; that of the pressure shows only beside shorter steps.
Json kept_bias(RunResult const& result, std::string const& text) {
  auto const& e = result.equilibrium;
  auto const se = [&](cg::Estimate const& T) {
    return sdpd::error_without_gain(T, result.gained_temperature);
  };
  auto const surely = [&](cg::Estimate const& T) { return std::abs(T.mean - 1) - 2 * se(T); };
  bool const kinetic = !result.settings.features().energies || surely(e.T_kin) > surely(e.T_int);
  auto const& T = kinetic ? e.T_kin : e.T_int;
  return kept(text, parse_share(text), std::abs(T.mean - 1), se(T));
}

/// Of the self-diffusion: what trials of the time step have shown of its excess or, where they did not tell,
/// that of a particle alone, which is the most that may be.
Json kept_dynamics(RunResult const& result, std::string const& text) {
  auto const& scheme = result.scene.scheme;
  double const excess = diffusion_excess_at_most(result);
  bool const known = scheme.diffusion_share && scheme.diffusion_share_se;
  Json json = known ? kept(text, parse_share(text), excess * std::abs(*scheme.diffusion_share),
                           excess * *scheme.diffusion_share_se)
                    : kept(text, parse_share(text), excess, 0);
  json["by"] = known ? "trials" : "bound";
  return json;
}

/// Nothing of what was found in trials of the fluid at rest where something drives the run.
Json kept_part(RunResult const& result, std::string const& name, std::string const& text) {
  bool const driven = is_driven(result.scene);
  if (name == "drift" && driven == text.ends_with('%'))
    return kept_drift(result, text);
  if (name == "bias" && !driven && result.settings.noise)
    return kept_bias(result, text);
  if (name == "dynamics" && !driven && result.settings.noise)
    return kept_dynamics(result, text);
  return {};
}

} // namespace

double diffusion_excess_at_most(RunResult const& result) {
  return sdpd::diffusion_excess(sdpd::velocity_decay_rate(result.settings),
                                result.settings.dt *
                                    static_cast<double>(result.scene.scheme.fluctuate_every));
}

Json kept_tolerances(RunResult const& result) {
  Json all;
  std::istringstream wanted(result.scene.scheme.dt_chosen_for.value_or(""));
  for (std::string part; std::getline(wanted >> std::ws, part, ',');) {
    auto const space = part.find(' ');
    if (space == std::string::npos)
      continue;
    auto const name = part.substr(0, space), text = part.substr(space + 1);
    try {
      if (auto const one = kept_part(result, name, text); !one.is_null())
        all[name] = one;
    } catch (InputError const&) {
      continue; // words that a user has written there
    }
  }
  return all;
}

} // namespace mesobridge::workflows
