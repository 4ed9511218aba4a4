#pragma once
#include "fitting/eos/list.hpp"
#include "fitting/internal_energy.hpp"
#include <optional>
#include <string>

namespace mesobridge::sdpd {

/// One of several species of SDPD particles, which share the kernel's support, viscosities and conductivity.
struct SdpdSpecies {
  std::string name;
  double share; ///< of the particles, > 0; those of all species sum to 1
  double K;     ///< size in atoms or molecules, >= 1 and with a heat capacity above k_B/2
  fitting::AnyEos eos;
};

inline double mass_of(SdpdSpecies const& species) {
  return species.K * std::visit([](auto const& eos) { return eos.molecular_mass(); }, species.eos);
}

/// One of several species of DPD or DPDE particles, which share the pair potential, friction and conduction.
struct PairSpecies {
  std::string name;
  double share;                                              ///< as above
  double mass;                                               ///< > 0, in the units of the settings
  std::optional<fitting::AnyInternalEnergy> internal_energy; ///< DPDE
};

inline double mass_of(PairSpecies const& species) {
  return species.mass;
}

} // namespace mesobridge::sdpd
