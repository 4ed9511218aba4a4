#pragma once
#include "md/error.hpp"
#include "md/units.hpp"
#include <cmath>

namespace mesobridge::sdpd {

/// The unit system of particles of size K (sdpd/README.md, Eq. (S1)): a particle's mass, the mean distance
/// between particles and K k_B T are one. Temperatures are counted in the set temperature, densities in the
/// mean density. The engine works in these units alone; Boltzmann's constant is 1/K in them.
struct ReducedUnits {
  double K;           ///< size: atoms or molecules per particle, >= 1
  double m0;          ///< mass of one atom or molecule (SI: kg)
  double density;     ///< mean density (SI: kg/m^3)
  double temperature; ///< set temperature (SI: K)
  double boltzmann;   ///< k_B in the units of the three quantities above (SI: J/K)

  double mass() const { return K * m0; }
  double length() const { return std::cbrt(mass() / density); }
  double energy() const { return K * boltzmann * temperature; }
  double time() const { return length() * std::sqrt(mass() / energy()); }
  double velocity() const { return length() / time(); }
  double pressure() const { return energy() / (length() * length() * length()); }
  double conductivity() const { return energy() / (length() * time() * temperature); }
  double viscosity() const { return pressure() * time(); }
  double specific_energy() const { return energy() / mass(); }
  double specific_entropy() const { return specific_energy() / temperature; }
};

} // namespace mesobridge::sdpd
