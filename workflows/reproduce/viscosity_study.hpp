#pragma once
#include "sdpd/method/settings.hpp"
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// One fluid whose viscosity is to be measured in a periodic box.
struct ViscosityCase {
  std::string name;                  ///< "sdpd", "dpd", "dpde"
  double K = 0;                      ///< SDPD
  double neighbours = 0;             ///< within the range
  sdpd::SimulationSettings settings; ///< along z the box holds one wave; no body force yet
};

/// Argon at 1150 kg/m^3 and 1000 K by SDPD with K = 10, 100, 1000 and 40, 65, 110 neighbours at two
/// viscosities each; the DPD fluid of Groot and Warren 1997, and DPDE of the same forces.
std::vector<ViscosityCase> viscosity_cases(std::uint64_t seed);

} // namespace mesobridge::workflows
