#include "fitting/published_jwl.hpp"
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::fitting {

ImpliedByJwl implied_by(PublishedJwl const& set) {
  for (auto const& [name, value] : {std::pair{"R1", set.R_1},
                                    {"R2", set.R_2},
                                    {"omega", set.omega},
                                    {"rho0", set.rho_0},
                                    {"D", set.D},
                                    {"P_CJ", set.P_CJ}})
    require(std::isfinite(value) && value > 0, fmt::format("JWL {}", name), value, "must be > 0");
  for (auto const& [name, value] :
       {std::pair{"A", set.A}, {"B", set.B}, {"E0", set.E_0}, {"C", set.C.value_or(0)}})
    require(std::isfinite(value), fmt::format("JWL {}", name), value, "must be finite");
  double const impedance = set.rho_0 * set.D * set.D;
  require(set.P_CJ < impedance, "JWL P_CJ", set.P_CJ,
          fmt::format("must be below rho0 D^2 = {:.6g} Pa", impedance));
  double const V = 1 - set.P_CJ / impedance;
  double const A = set.A * std::exp(-set.R_1 * V), B = set.B * std::exp(-set.R_2 * V);
  double const rest = set.P_CJ - A - B; // C V^-(omega+1)
  double const slope = A * set.R_1 + B * set.R_2 + (set.omega + 1) * rest / V;
  require(slope > 0, "JWL", slope, "the pressure of the isentrope must fall in expansion");
  return {.V_CJ = V,
          .C = rest * std::pow(V, set.omega + 1),
          .E_0 = A / set.R_1 + B / set.R_2 + rest * V / set.omega - 0.5 * set.P_CJ * (1 - V),
          .D_of_slope = std::sqrt(slope / set.rho_0)};
}

} // namespace mesobridge::fitting
