#pragma once
#include "sdpd/observe/equilibrium.hpp"

namespace mesobridge::sdpd {

/// What a run's own samples say against it.
struct Finding {
  std::string name; ///< "equipartition", "temperature", "trend_of_P" ...
  bool spoils;      ///< the state is not the scene's; else a warning
  std::string text; ///< in plain words, with numbers
};

/// What of a run is not in its samples; reduced units.
struct HealthConditions {
  bool has_motion = true;   ///< thermal motion, and with it a kinetic temperature
  bool keeps_energy = true; ///< false: a thermostat gives and takes energy
  bool was_equilibrated = true;
  /// That the time step has added and that stands in the errors of the temperatures: it is no excuse for
  /// being far from the set one.
  double gained_temperature = 0;
  double thermal_energy = 0;       ///< heat capacity of all particles times the set temperature
  double thermal_pressure = 0;     ///< of an ideal gas of the fluid's molecules
  double tolerable_pairing = 0.01; ///< see pairing.hpp
  /// Of bonds or of the start's lattice (lattice_order()). SDPD of argon with 65 neighbours has less than
  /// 0.03 of either where no lattice is left, and 0.4 ... 0.6 where one is (K = 10^4, after 2500 steps).
  double tolerable_crystal = 0.2;
};

/// How far a straight line through a series rises from its first sample to its last.
struct Trend {
  double change = 0, se = 0;
};
/// By least squares; the standard error from what the line leaves over, with its memory. Throws InputError
/// for fewer than 16 samples.
Trend trend(std::span<double const> series);

/// The error of a temperature without what the time step has added to it.
double error_without_gain(cg::Estimate const& T, double gained_temperature);

/// Compares the temperatures with each other and with the set one, which is 1, looks for means that still
/// drift, for an energy that is not kept, for particles in pairs and for a crystal. A finding is beyond five
/// standard errors (pairs and crystals: two) and large: an error of one or two per cent that a long time step
/// brings is a trade-off, not a finding. Empty for a good run.
std::vector<Finding> examine(EquilibriumSampler const& samples, Equilibrium const& means,
                             HealthConditions const& conditions);

} // namespace mesobridge::sdpd
