#pragma once
#include "cg/metal_point.hpp"

namespace mesobridge::cg {

/// A straight line y = a + b x with the covariance of its coefficients.
struct Line {
  double a = 0, b = 0;
  double var_a = 0, cov_ab = 0, var_b = 0;
  double chi_2 = 0;
};

/// A state behind a shock. The estimates' n_eff is not used.
struct HugoniotPoint {
  md::MetalState initial;
  double rho = 0; ///< [kg/m^3], exact
  Estimate v_P;   ///< velocity of the matter behind the shock [m/s]
  Estimate v_S;   ///< velocity of the shock [m/s]
  double cov_vSvP = 0;
  Estimate T, P, e; ///< [K], [Pa], [J/kg]
  Estimate P0;      ///< of the initial state [Pa]
  Phase phase = Phase::solid;
  double chi_2 = 0; ///< of the states about the straight line
  int states = 0;   ///< that the line goes through
};

/// The state at the density of `shocked` that a shock reaches from `initial`: the zero of
/// h(T) = e - e0 - (P + P0)(1/rho0 - 1/rho)/2 (cg/README.md, Eq. (C6)), on straight lines e(T), P(T) through
/// states of different T, weighted by the error of h. v_P^2 = (P - P0)(1/rho0 - 1/rho), v_S = v_P rho/(rho -
/// rho0). All errors come from those of e and P of each state and of the initial one, with their covariance
/// in each run. Throws InputError for fewer than 2 temperatures or other densities, PhysicsError where h does
/// not grow with T or the pressure is not above P0.
HugoniotPoint solve_hugoniot(MetalPoint const& initial, std::span<MetalPoint const> shocked);

/// The density of zero pressure on a straight line P(rho) through states of one temperature, with its error.
/// Throws InputError for fewer than 2 states, PhysicsError where P does not grow with rho.
Estimate zero_pressure_density(std::span<MetalPoint const> states);

/// v_S = c0 + s v_P through points of one Hugoniot curve, with errors in both (their correlation included) as
/// effective variances. Where the points leave a straight line by more than their errors (chi_2 above the
/// degrees of freedom), the covariance is that of their scatter about it. Throws InputError for fewer than 3
/// points.
Line fit_us_up(std::span<HugoniotPoint const> points);

} // namespace mesobridge::cg
