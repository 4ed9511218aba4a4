#pragma once
#include "fitting/shock_relations.hpp"

namespace mesobridge::fitting {

/// Constant transport coefficients, in the units of the model (SI: Pa s, Pa s, W/(m K)).
struct Transport {
  double shear_viscosity;
  double bulk_viscosity = 0;
  double conductivity = 0;
};

/// One place in the front. x counts along the direction of travel from where v = v_P/2: x < 0 lies behind.
struct ProfilePoint {
  double x;
  double v; ///< velocity of the matter in the laboratory: v_P behind, 0 ahead
  double dv_dx, dT_dx;
  EosState state;
};

/// The steady front of a shock in a viscous and heat-conducting fluid.
struct ShockProfile {
  Shock shock;
  Transport transport;
  std::vector<ProfilePoint> points; ///< of rising x
  double thickness;                 ///< v_P over the steepest slope of v
};

/// Solves the one-dimensional steady Navier-Stokes equations in the frame of the shock (fitting/README.md,
/// Eq. (F17); the thesis's (5.1) has eta for 4 eta/3 + zeta). With the flow velocity w = v_S - v, the mass
/// flux m = rho w and mu = 4 eta/3 + zeta, along the flow:
///   m w + P - mu w' = m v_S + P_0,
///   m (e + w^2/2) + (P - mu w') w - kappa T' = m (e_0 + v_S^2/2) + P_0 v_S.
/// The state behind is a saddle of these equations; the front is the path that leaves it against the flow and
/// ends in the state ahead. GSL integrates it (Runge-Kutta, Prince-Dormand 8/9) until velocity and
/// temperature are within `end` of those ahead, relative to their jumps. Throws InputError for coefficients
/// that are negative or all of whose viscosities vanish, PhysicsError if the path leaves the model or does
/// not arrive (the ratio of the coefficients is too extreme).
ShockProfile shock_profile(Fluid const& fluid, Shock const& shock, Transport const& transport,
                           double end = 1e-6);

} // namespace mesobridge::fitting
