#pragma once
#include <cmath>

namespace mesobridge::sdpd {

/// Temperature and heat capacity of a particle at fixed density whose energy has changed by u since the
/// expansion began:
///     T(u) = T_0 + u (1/C_0 + c u),  1/C(u) = 1/C_0 + 2 c u,  c = -(dC/dT) / 2 C^3,
/// exact for a constant heat capacity; otherwise its relative error is of third order in (T - T_0)/T_0, and
/// the engine begins a new one (one warm Newton inversion) when |T - T_0| reaches `limit` (infinite for a
/// constant heat capacity). So two
/// multiplications take the place of an inversion of the equation of state for each pair. Energy is conserved
/// whatever the error is, because the energies are the variables; only the friction feels it, through T.
struct Caloric {
  double T_0, inverse_C_0, curvature, limit;

  double T(double u) const { return T_0 + u * (inverse_C_0 + curvature * u); }
  double inverse_C(double u) const { return inverse_C_0 + 2 * curvature * u; }
  /// False when T is not a number.
  bool in_reach(double u) const { return std::abs(T(u) - T_0) < limit; }
  /// S(T_1) - S(T): with C = C_0 + C' (T - T_0), C' = -2 c C_0^3, the integral of C/T.
  double entropy_change(double T, double T_1) const {
    double const C_0 = 1 / inverse_C_0, slope = -2 * curvature * C_0 * C_0 * C_0;
    return (C_0 - slope * T_0) * std::log(T_1 / T) + slope * (T_1 - T);
  }
};

/// Largest relative change of T that an expansion serves when the heat capacity varies; T is then right to
/// about 1e-5 for the LJ fluid.
inline constexpr double caloric_reach = 0.03;

} // namespace mesobridge::sdpd
