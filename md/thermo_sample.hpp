#pragma once
#include <cstdint>

namespace mesobridge::md {

/// One instant of a fluid of N atoms in Lennard-Jones units; U and P include the tail corrections if there
/// are any. The kinetic parts of U and P are the measured ones, 3T/2 and rho T with this T, so that an
/// analysis can put the exact ones in their place.
struct ThermoSample {
  std::int64_t step = 0;
  double T = 0; ///< kinetic temperature, 2/(3N) times the kinetic energy
  double U = 0; ///< total energy (kinetic and potential) per atom
  double P = 0; ///< pressure
};

} // namespace mesobridge::md
