#pragma once
#include "fitting/kinetics.hpp"
#include "fitting/reactive_fluid.hpp"

namespace mesobridge::fitting {

/// How a homogeneous explosive at constant volume without loss of heat explodes by itself (fitting/README.md,
/// Eq. (F25)), and what follows for a shock that a piston sustains.
struct ThermalExplosion {
  double time;              ///< until `exploded` has reacted [s]
  double frank_kamenetskii; ///< c_v T^2/(q T_a)/rate at the beginning: of a reactant that is not used up [s]
  MixtureState end;         ///< when all has reacted

  /// Progress at which an explosion counts as done: nearly all of the time passes before a tenth of it.
  static constexpr double exploded = 0.9;
};

/// From the reactant's density and energy. Throws PhysicsError where the reaction stands still, or a mixture
/// on the way has no stable state.
ThermalExplosion thermal_explosion(ReactiveFluid const& fluid, double rho, double e,
                                   Kinetics const& kinetics);

/// Shock to detonation in a homogeneous explosive: what the piston shocked first explodes first, and a
/// detonation runs through the shocked matter until it overtakes the shock. Velocities in the laboratory.
struct ShockToDetonation {
  Shock shock;
  ThermalExplosion explosion; ///< of the shocked matter
  double super_detonation;    ///< velocity of the detonation in it [m/s]
  double time, place;         ///< where it overtakes the shock, from the piston's start [s, m]
};
ShockToDetonation shock_to_detonation(ReactiveFluid const& fluid, double v_P, Kinetics const& kinetics);

} // namespace mesobridge::fitting
