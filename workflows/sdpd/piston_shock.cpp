#include "workflows/sdpd/piston_shock.hpp"

namespace mesobridge::workflows {

namespace {

fitting::EosState state_ahead(sdpd::Sdpd const& fluid, sdpd::SimulationSettings const& settings) {
  return std::visit(
      [&](auto const& eos) { return fitting::state_from_temperature(eos, settings.rho, settings.T); },
      fluid.eos);
}

fitting::Shock detonation(sdpd::Sdpd const& fluid, sdpd::SimulationSettings const& settings, double v_P) {
  fitting::Hugoniot const crussard(state_ahead(fluid, settings), fitting::Fluid(fluid.reaction->product),
                                   fluid.reaction->heat);
  auto const free = crussard.chapman_jouguet();
  return v_P > free.v_P ? crussard.from_piston(v_P) : free;
}

} // namespace

std::optional<fitting::Shock> piston_shock(sdpd::SimulationSettings const& settings, double v_P) {
  auto const* fluid = std::get_if<sdpd::Sdpd>(&settings.method);
  if (!fluid)
    return std::nullopt;
  return fitting::Hugoniot(fitting::Fluid(fluid->eos), state_ahead(*fluid, settings)).from_piston(v_P);
}

std::optional<fitting::Shock> shock_before_piston(sdpd::SimulationSettings const& settings) {
  for (auto const& [lower, upper] : settings.faces)
    if (double const v_P = lower.motion.driving_velocity(); v_P > 0)
      try {
        auto const* fluid = std::get_if<sdpd::Sdpd>(&settings.method);
        return fluid && fluid->reaction ? detonation(*fluid, settings, v_P) : piston_shock(settings, v_P);
      } catch (PhysicsError const&) {
        return std::nullopt;
      }
  return std::nullopt;
}

std::optional<double> steps_to_far_wall(sdpd::SimulationSettings const& settings) {
  if (settings.layout || settings.features().reacts)
    return std::nullopt;
  auto const units = settings.units();
  auto const edge = sdpd::box_of(settings).edge;
  for (int axis = 0; axis < 3; ++axis) {
    auto const& [lower, upper] = settings.faces[static_cast<std::size_t>(axis)];
    double const v_P = lower.motion.driving_velocity();
    if (!(v_P > 0) || upper.kind != sdpd::FaceKind::wall)
      continue;
    auto const shock = shock_before_piston(settings);
    if (!shock)
      return std::nullopt;
    double const started = lower.motion.table.empty() ? lower.motion.ramp : lower.motion.table.back().time,
                 lag = started - lower.motion.way_at(started) / v_P;
    return (component(edge, axis) * units.length() / shock->v_S + lag) / units.time() / settings.dt;
  }
  return std::nullopt;
}

double front_reynolds_number(sdpd::SimulationSettings const& settings, fitting::Shock const& shock) {
  auto const& fluid = settings.as<sdpd::Sdpd>();
  return shock.ahead.rho * shock.v_S * settings.spacing() * settings.units().length() /
         (4 * fluid.eta / 3 + fluid.zeta);
}

} // namespace mesobridge::workflows
