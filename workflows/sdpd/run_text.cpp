#include "workflows/sdpd/run_text.hpp"
#include "workflows/report/number_text.hpp"
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

} // namespace

std::string run_text(RunResult const& result) {
  auto const& [scene, e] = std::tie(result.scene, result.equilibrium);
  bool const si = scene.units == UnitSystem::SI;
  OutputUnits const units(result.settings.units(), scene.units);
  auto const features = result.settings.features();
  std::string const T_unit = si ? "K" : "", rho_unit = si ? "kg/m^3" : "";
  std::string text = line("T_kin", e.T_kin, units.temperature, T_unit, set(scene.fluid.T, T_unit));
  if (features.energies)
    text += line("T_int", e.T_int, units.temperature, T_unit);
  text += line("P", e.P, units.pressure, si ? "Pa" : "");
  if (features.densities)
    text += line("rho", e.rho.mean, units.density, rho_unit, set(scene.fluid.rho, rho_unit));
  if (features.energies) {
    text += line("e", e.eps.mean, units.specific_energy, si ? "J/kg" : "");
    constexpr double ps = 1e-12;
    text += line("drift", {e.drift.rate, e.drift.se, 8}, (si ? ps : 1) / units.time, si ? "/ps" : "",
                 "of the total energy, relative");
  }
  return text;
}

} // namespace mesobridge::workflows
