#pragma once
#include "fitting/shock_relations.hpp"
#include "sdpd/method/settings.hpp"
#include <optional>

namespace mesobridge::workflows {

/// The shock that a piston drives into the fluid of the settings, by the relations of Rankine and Hugoniot of
/// its equation of state; nothing for particles without one. v_P > 0, in the units of the settings. Throws
/// PhysicsError where the model has no such shock.
std::optional<fitting::Shock> piston_shock(sdpd::SimulationSettings const& settings, double v_P);

/// The same before the piston of the settings; of a fluid that reacts the detonation, that of Chapman and
/// Jouguet where the piston is slower than its products, else the one that the piston drives. Nothing where
/// no piston moves into the fluid, and where the models have no such shock.
std::optional<fitting::Shock> shock_before_piston(sdpd::SimulationSettings const& settings);

/// Steps of the settings' dt until the front of that shock, which lags behind one that began at full velocity
/// by the piston's start, comes to the wall at the far end. Nothing where there is no such wall, for regions,
/// whose fluids differ, and for fluids that react, whose front becomes faster at a time that nobody knows.
std::optional<double> steps_to_far_wall(sdpd::SimulationSettings const& settings);

/// Re_l = rho_0 v_S l/(4 eta/3 + zeta) of a shock in SDPD with the settings, whose viscosity is not zero; l
/// is the mean distance between particles. Above smooth_front the state behind the front ripples
/// (sdpd/README.md, Eq. (S43)).
double front_reynolds_number(sdpd::SimulationSettings const& settings, fitting::Shock const& shock);
inline constexpr double smooth_front = 2;

} // namespace mesobridge::workflows
