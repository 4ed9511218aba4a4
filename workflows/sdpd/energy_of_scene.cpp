#include "workflows/sdpd/energy_of_scene.hpp"
#include "workflows/scene/driven.hpp"

namespace mesobridge::workflows {

std::optional<sdpd::SetEnergy> energy_of_scene(Scene const& scene, sdpd::SimulationSettings const& settings,
                                               sdpd::Simulation const& simulation) {
  if (simulation.has_thermostat() || !simulation.has_noise() || is_driven(scene) ||
      scene.run.equilibrate == 0 || !settings.features().energies)
    return std::nullopt;
  double const K = settings.K();
  return sdpd::SetEnergy{.last_part =
                             sdpd::last_share_of_equilibration * double(scene.run.equilibrate) * settings.dt,
                         .kinetic_capacity = 1.5 * (double(simulation.size()) - 1) / K,
                         .capacity = simulation.heat_capacity() / K,
                         .pressure_slope = sdpd::pressure_slope(settings),
                         .particles = simulation.size()};
}

} // namespace mesobridge::workflows
