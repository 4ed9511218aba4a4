#pragma once
#include "fitting/eos/jwl.hpp"
#include <optional>

namespace mesobridge::fitting {

/// A set of JWL numbers as handbooks print it, SI. It says more than the equation of state has room for.
struct PublishedJwl {
  double A, B, R_1, R_2, omega;
  double rho_0;            ///< of the explosive [kg/m^3]
  double E_0;              ///< energy of detonation per volume of the explosive [J/m^3]
  double D, P_CJ;          ///< detonation velocity [m/s] and pressure [Pa]
  std::optional<double> C; ///< of the isentrope [Pa]
};

/// What some of the numbers of a set imply for the others (fitting/README.md, Eq. (F28)).
struct ImpliedByJwl {
  double V_CJ;       ///< rho_0/rho at the Chapman-Jouguet point, by rho_0, D and P_CJ
  double C;          ///< by the pressure there [Pa]
  double E_0;        ///< by the energy there [J/m^3]
  double D_of_slope; ///< velocity whose Rayleigh line has the slope of the isentrope there [m/s]
};

/// Throws InputError for a set whose P_CJ is not below rho_0 D^2, or numbers out of range.
ImpliedByJwl implied_by(PublishedJwl const& set);

} // namespace mesobridge::fitting
