#pragma once
#include "cg/estimate.hpp"
#include "sdpd/simulation.hpp"
#include <functional>

namespace mesobridge::sdpd {

/// How a fluid is pushed to tell its viscosity.
struct ViscosityWave {
  int waves = 1;                        ///< in the length of the box along z
  double amplitude = 0.7;               ///< wanted of the flow, over the thermal velocity (k_B T/m)^(1/2)
  std::optional<double> expected = {};  ///< viscosity in the units of the method; nothing: that of Eq. (S55)
  std::optional<Checkpoint> start = {}; ///< of as many particles, at equilibrium; nothing: found here
};

/// Viscosity in the units of the method.
struct MeasuredViscosity {
  cg::Estimate viscosity, T_kin; ///< T_kin over the set temperature, without the flow
  double amplitude = 0;          ///< of the velocity, over the thermal velocity
  std::uint64_t steps = 0;
};

/// In which such a wave forgets its start, at its expected viscosity, reduced.
double relaxation_time(SimulationSettings const& settings, ViscosityWave const& of = {});

/// The fluid at equilibrium after so much time [reduced], from which several waves may start. Throws
/// PhysicsError as the engine does; Interrupted.
Checkpoint state_before_waves(SimulationSettings settings, double time,
                              std::function<bool()> const& keep_going);

/// Pushes the fluid by a wave of body force (sdpd/README.md, Eq. (S54)) and takes the viscosity from the
/// amplitude of the flow, which a first part of a quarter of the `time` [reduced] brings to the wanted one.
/// The box is that of the settings, periodic and without a body force. Throws Interrupted when `keep_going`
/// says no, PhysicsError as the engine does, and where nothing flows.
MeasuredViscosity measure_viscosity(SimulationSettings settings, double time,
                                    std::function<bool()> const& keep_going, ViscosityWave const& of = {});

} // namespace mesobridge::sdpd
