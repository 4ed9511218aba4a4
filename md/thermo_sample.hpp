#pragma once
#include <cstdint>

namespace mesobridge::md {

/// One instant of a fluid of N atoms in Lennard-Jones units; U and P include the tail corrections if there are any.
struct ThermoSample {
  std::int64_t step = 0;
  double T = 0; ///< kinetic temperature
  double U = 0; ///< total energy (kinetic and potential) per atom
  double P = 0; ///< pressure
};

} // namespace mesobridge::md
