#pragma once
#include "cg/estimate.hpp"
#include "sdpd/method/settings.hpp"
#include <functional>

namespace mesobridge::workflows {

/// One fluid whose viscosity is to be measured in a periodic box.
struct ViscosityCase {
  std::string name;                  ///< "sdpd", "dpd", "dpde"
  double K = 0;                      ///< SDPD
  double neighbours = 0;             ///< within the range
  sdpd::SimulationSettings settings; ///< along z the box holds one wave; no body force yet
};

/// In the units of the method.
struct MeasuredViscosity {
  cg::Estimate viscosity, T_kin; ///< T_kin over the set temperature, without the flow
  double amplitude = 0;          ///< of the velocity, over the thermal velocity (k_B T/m)^(1/2)
};

/// In which such a wave forgets its start, at the viscosity of Eq. (S55), reduced.
double relaxation_time(sdpd::SimulationSettings const& settings);

/// Pushes the fluid by a wave of body force (sdpd/README.md, Eq. (S54)) and takes the viscosity from the
/// amplitude of the flow, which a first part of a quarter of the `time` [reduced] brings to 0.7 times the
/// thermal velocity. Throws Interrupted when `keep_going` says no, PhysicsError as the engine does, and where
/// nothing flows.
MeasuredViscosity measure_viscosity(sdpd::SimulationSettings settings, double time,
                                    std::function<bool()> const& keep_going);

/// Argon at 1150 kg/m^3 and 1000 K by SDPD with K = 10, 100, 1000 and 40, 65, 110 neighbours at two
/// viscosities each; the DPD fluid of Groot and Warren 1997, and DPDE of the same forces.
std::vector<ViscosityCase> viscosity_cases(std::uint64_t seed);

} // namespace mesobridge::workflows
