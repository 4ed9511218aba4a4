#include "workflows/sdpd/run_text.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// A quantity, its value in the scene's units, and what else is to be said of it.
std::string line(std::string const& name, cg::Estimate const& reduced, double unit,
                 std::string const& unit_name, std::string const& remark = "") {
  auto const value = with_error_text({reduced.mean * unit, reduced.se * unit, reduced.n_eff});
  return fmt::format("{:<7} {}{}{}\n", name, value, unit_name.empty() ? "" : " " + unit_name,
                     remark.empty() ? "" : "  (" + remark + ")");
}

std::string set(double value, std::string const& unit_name) {
  return fmt::format("set: {}{}", number_text(value, 6), unit_name.empty() ? "" : " " + unit_name);
}

/// What a piston's run shows of its shock, by its summary; nothing where there is none.
std::string shock_text(Json const& summary, OutputUnits const& units, bool si) {
  struct Shown {
    std::string name, key, exact, unit;
  };
  std::string text;
  for (auto const& [name, key, exact, unit] :
       {Shown{"v_S", "shock_v_S" + units.velocity_key, "v_S" + units.velocity_key, "m/s"},
        Shown{"rho", "plateau_rho" + units.density_key, "rho" + units.density_key, "kg/m^3"},
        Shown{"P", "plateau_P" + units.pressure_key, "P" + units.pressure_key, "Pa"},
        Shown{"T", "plateau_T" + units.temperature_key, "T" + units.temperature_key, "K"}})
    if (summary.contains(key)) {
      cg::Estimate const found{summary[key].get<double>(), summary[key + "_se"].get<double>(), 1};
      std::string const remark =
          summary.contains("rankine_hugoniot")
              ? "Rankine-Hugoniot: " + number_text(summary["rankine_hugoniot"][exact].get<double>(), 6)
              : "";
      text += line(name, found, 1, si ? unit : "", remark);
    }
  return text.empty() ? "" : "the shock, and the state behind it:\n" + text;
}

/// What a run shows of its detonation, by its summary; nothing where there is none.
std::string detonation_text(Json const& summary, OutputUnits const& units, bool si) {
  auto const D = "detonation_D" + units.velocity_key, zone = "reaction_zone" + units.length_key;
  if (!summary.contains(D))
    return "";
  auto const found = [&](std::string const& key) {
    return cg::Estimate{summary[key].get<double>(), summary[key + "_se"].get<double>(), 1};
  };
  auto const& cj = summary["chapman_jouguet"]["D" + units.velocity_key];
  return "the detonation, and its reaction zone:\n" +
         line("D", found(D), 1, si ? "m/s" : "", "Chapman-Jouguet: " + number_text(cj.get<double>(), 6)) +
         line("zone", found(zone), 1, si ? "m" : "",
              summary.contains("znd")
                  ? "ZND: " + number_text(summary["znd"]["zone" + units.length_key].get<double>(), 4)
                  : "");
}

/// The viscosity and the slip of a flow, by its summary; nothing where there are none.
std::string flow_text(Json const& summary, OutputUnits const& units, bool si) {
  std::string text;
  for (auto const& [name, key, unit] :
       {std::tuple("eta", std::string(si ? "viscosity_Pa_s" : "viscosity"), "Pa s"),
        {"slip", "slip_length" + units.length_key, "m"}})
    if (summary.contains(key))
      text +=
          line(name, {summary[key].get<double>(), summary[key + "_se"].get<double>(), 1}, 1, si ? unit : "");
  return text.empty() ? "" : "the flow, viscosity and slip length:\n" + text;
}

} // namespace

std::string run_text(RunResult const& result) {
  auto const& [scene, e] = std::tie(result.scene, result.equilibrium);
  bool const si = scene.units == UnitSystem::SI;
  OutputUnits const units(result.settings.units(), scene.units);
  auto const features = result.settings.features();
  bool const driven = is_driven(scene);
  std::string const T_unit = si ? "K" : "", rho_unit = si ? "kg/m^3" : "";
  std::string text;
  if (result.settings.noise) // what flows without noise has no temperature of its motion
    text += line("T_kin", e.T_kin, units.temperature, T_unit, driven ? "" : set(scene.fluid.T, T_unit));
  if (features.energies)
    text += line("T_int", e.T_int, units.temperature, T_unit);
  text += line("P", e.P, units.pressure, si ? "Pa" : "");
  if (features.densities)
    text += line("rho", e.rho.mean, units.density, rho_unit, driven ? "" : set(scene.fluid.rho, rho_unit));
  if (features.energies) {
    text += line("e", e.eps.mean, units.specific_energy, si ? "J/kg" : "");
    constexpr double ps = 1e-12;
    text += line("drift", {e.drift.rate, e.drift.se, 8}, (si ? ps : 1) / units.time, si ? "/ps" : "",
                 "of the total energy, relative");
    if (driven) {
      auto const share = result.summary["energy_balance_error"].get<double>();
      auto const& chosen_for = scene.scheme.dt_chosen_for;
      text += fmt::format("{:<7} {} %  (of the energy that was turned over is missing{})\n", "balance",
                          number_text(100 * share, 2),
                          chosen_for ? "; the time step was chosen for " + *chosen_for : "");
    }
  }
  if (result.summary.contains("tolerances"))
    for (auto const& [name, kept] : result.summary["tolerances"].items())
      text += fmt::format("{:<7} {} ± {} of the tolerated {}: {}\n", name,
                          number_text(kept["found_over_wanted"].get<double>(), 2),
                          number_text(kept["found_over_wanted_se"].get<double>(), 2),
                          kept["tolerance"].get<std::string>(),
                          kept["fulfilled"].get<bool>() ? "fulfilled" : "not fulfilled");
  if (auto const viscosities = viscosities_text(scene, result.summary); !viscosities.empty())
    text += fmt::format("{:<7} {}\n", "eta", viscosities);
  return text + shock_text(result.summary, units, si) + detonation_text(result.summary, units, si) +
         flow_text(result.summary, units, si);
}

} // namespace mesobridge::workflows
