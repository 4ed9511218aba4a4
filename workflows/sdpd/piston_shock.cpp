#include "workflows/sdpd/piston_shock.hpp"

namespace mesobridge::workflows {

std::optional<fitting::Shock> piston_shock(sdpd::SimulationSettings const& settings, double v_P) {
  auto const* fluid = std::get_if<sdpd::Sdpd>(&settings.method);
  if (!fluid)
    return std::nullopt;
  auto const ahead = std::visit(
      [&](auto const& eos) { return fitting::state_from_temperature(eos, settings.rho, settings.T); },
      fluid->eos);
  return fitting::Hugoniot(fitting::Fluid(fluid->eos), ahead).from_piston(v_P);
}

std::optional<fitting::Shock> shock_before_piston(sdpd::SimulationSettings const& settings) {
  for (auto const& [lower, upper] : settings.faces)
    if (double const v_P = lower.motion.driving_velocity(); v_P > 0)
      try {
        return piston_shock(settings, v_P);
      } catch (PhysicsError const&) {
        return std::nullopt;
      }
  return std::nullopt;
}

double front_reynolds_number(sdpd::SimulationSettings const& settings, fitting::Shock const& shock) {
  auto const& fluid = settings.as<sdpd::Sdpd>();
  return shock.ahead.rho * shock.v_S * settings.spacing() * settings.units().length() /
         (4 * fluid.eta / 3 + fluid.zeta);
}

} // namespace mesobridge::workflows
