#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/observe/equilibrium.hpp"

namespace mesobridge::sdpd {

/// Of the steps of equilibrate(): over them the temperature is last measured and then set.
constexpr double last_share_of_equilibration = 0.5;

/// How equilibrate() set the energy that a run then keeps, and what hangs on it; reduced units.
struct SetEnergy {
  double last_part = 0;        ///< time over which the temperature was last measured, > 0
  double kinetic_capacity = 0; ///< dE/dT of the motion of all particles
  double capacity = 0;         ///< the same with their internal energies
  double pressure_slope = 0;   ///< dP/dT at constant volume
  std::size_t particles = 1;
};

/// dP/dT at constant volume of the settings' fluid, reduced: that of the equation of state; of DPDE and DPD
/// the part of the motion alone.
double pressure_slope(SimulationSettings const& settings);

/// Standard error of the temperature that the energy of a run stands for (sdpd/README.md, Eq. (S90)): from
/// what it was set by, and from what the time step has added since. Throws InputError for fewer than 32
/// samples.
double set_temperature_error(EquilibriumSampler const& samples, SetEnergy const& set);

/// The part of it that the time step has added: what the mean energy has gained since the first sample, as a
/// temperature, of either sign.
double gained_temperature(EquilibriumSampler const& samples, SetEnergy const& set);

/// Adds it to the errors of the temperatures, the pressure and the internal energy (S91): a run's own samples
/// know nothing of it.
void add_error_of_set_energy(Equilibrium& means, double temperature_error, SetEnergy const& set);

} // namespace mesobridge::sdpd
