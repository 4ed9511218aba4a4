#pragma once
#include "sdpd/method/settings.hpp"

namespace mesobridge::sdpd {

/// The shear viscosity of a fluid without structure, in two parts and in the units of the method
/// (sdpd/README.md, Eq. (S55)). What the conservative forces add in stiff fluids has no formula.
struct MeanFieldViscosity {
  double dissipative; ///< of the friction between particles: SDPD's eta
  double kinetic;     ///< of the momentum that moving particles carry; infinite without friction

  double sum() const { return dissipative + kinetic; }
};

/// Of one species: with several, of particles of the mean mass with the first one's friction.
MeanFieldViscosity mean_field_viscosity(SimulationSettings const& settings);

/// The factor of the friction with a wall's images that leaves next to no slip, by measurements in Couette
/// flow (Eq. (S52)).
double usual_wall_friction(SimulationSettings const& settings);

} // namespace mesobridge::sdpd
