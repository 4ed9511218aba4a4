#pragma once
#include "sdpd/observe/set_energy.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/scene/scene.hpp"
#include <optional>

namespace mesobridge::workflows {

/// How the energy of a run was set; nothing where a thermostat, something that drives it or no noise decides,
/// or where the scene asks for no equilibrium.
std::optional<sdpd::SetEnergy> energy_of_scene(Scene const& scene, sdpd::SimulationSettings const& settings,
                                               sdpd::Simulation const& simulation);

} // namespace mesobridge::workflows
