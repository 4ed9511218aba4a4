#pragma once
#include "fitting/shock_relations.hpp"
#include "sdpd/method/settings.hpp"
#include <optional>

namespace mesobridge::workflows {

/// The shock that a piston drives into the fluid of the settings, by the relations of Rankine and Hugoniot of
/// its equation of state; nothing for particles without one. v_P > 0, in the units of the settings. Throws
/// PhysicsError where the model has no such shock.
std::optional<fitting::Shock> piston_shock(sdpd::SimulationSettings const& settings, double v_P);

} // namespace mesobridge::workflows
