#pragma once
#include "md/error.hpp"

namespace mesobridge {

/// Exact SI values (2019).
inline constexpr double k_B = 1.380649e-23;              ///< Boltzmann's constant [J/K]
inline constexpr double N_A = 6.02214076e23;             ///< Avogadro's constant [1/mol]
inline constexpr double atomic_mass = 1.66053906660e-27; ///< [kg], CODATA 2018

/// The Lennard-Jones unit system of one substance: SI = reduced * unit.
struct LjUnits {
  double sigma;   ///< length [m]
  double epsilon; ///< energy [J]
  double mass;    ///< mass of one atom [kg]

  double temperature() const { return epsilon / k_B; }                  ///< [K]
  double density() const { return mass / (sigma * sigma * sigma); }     ///< [kg/m^3] at rho* = 1
  double pressure() const { return epsilon / (sigma * sigma * sigma); } ///< [Pa]
  double specific_energy() const { return epsilon / mass; }             ///< [J/kg]
  double velocity() const { return std::sqrt(epsilon / mass); }         ///< [m/s]
  double time() const { return sigma / velocity(); }                    ///< [s]
};

/// Argon as the thesis takes it, with the mass m0 corrected to 6.64e-26 kg (md/README.md, Eq. (M1)).
inline constexpr LjUnits argon_units{.sigma = 3.405e-10, .epsilon = 1.657e-21, .mass = 6.64e-26};

} // namespace mesobridge
