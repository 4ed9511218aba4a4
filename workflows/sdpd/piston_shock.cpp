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

} // namespace mesobridge::workflows
