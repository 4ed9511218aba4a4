#pragma once
#include "fitting/eos/list.hpp"
#include "fitting/internal_energy.hpp"
#include "md/number_range.hpp"
#include "sdpd/thermodynamics/mixture.hpp"
#include <string>

namespace mesobridge::sdpd {

constexpr NumberRange species_shares{.min = 0, .open = true, .max = 1}; ///< of a species among the particles

/// One of several species of SDPD particles, which share the kernel's support, viscosities and conductivity.
struct SdpdSpecies {
  std::string name;
  double share; ///< of the particles, > 0; those of all species sum to 1
  double K;     ///< size in atoms or molecules, >= 1 and with a heat capacity above k_B/2
  fitting::AnyEos eos;
  double rho = 0, T = 0; ///< where it begins; 0: at those of the settings
};

inline double mass_of(SdpdSpecies const& species) {
  return species.K * std::visit([](auto const& eos) { return eos.molecular_mass(); }, species.eos);
}

/// One of several species of DPD particles, which share the pair potential and friction.
struct DpdSpecies {
  std::string name;
  double share; ///< as above
  double mass;  ///< > 0, in the units of the settings
};

/// One of several species of DPDE particles, which share the conduction, too.
struct DpdeSpecies {
  std::string name;
  double share; ///< as above
  double mass;  ///< > 0, in the units of the settings
  fitting::AnyInternalEnergy internal_energy;
};

inline double mass_of(auto const& species) {
  return species.mass;
}

/// Of particles of several species, each of which has what `make` makes of it.
template <class AnySpecies, class Make>
std::unique_ptr<Thermodynamics const> mixture_of(std::vector<AnySpecies> const& species, Make const& make) {
  std::vector<std::unique_ptr<Thermodynamics const>> parts;
  for (auto const& of : species)
    parts.push_back(make(of));
  return make_mixture(std::move(parts));
}

} // namespace mesobridge::sdpd
