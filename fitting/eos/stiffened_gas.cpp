#include "fitting/eos/stiffened_gas.hpp"

namespace mesobridge::fitting {

StiffenedGas::StiffenedGas(StiffenedGasParameters const& p) : p_(p) {
  require(p.gamma > 1 && std::isfinite(p.gamma), "stiffened gas gamma", p.gamma, "must be > 1 and finite");
  require(p.P_inf >= 0 && std::isfinite(p.P_inf), "stiffened gas P_inf", p.P_inf, "must be >= 0 and finite");
  require_positive("stiffened gas c_v", p.c_v);
  require_finite("stiffened gas q", p.q);
  require_positive("stiffened gas m0", p.m0);
  require(p.b >= 0 && std::isfinite(p.b), "stiffened gas b", p.b, "must be >= 0 and finite");
}

Domain StiffenedGas::domain() const {
  double const infinity = std::numeric_limits<double>::infinity();
  return {.rho_min = 0,
          .rho_max = rho_max(),
          .T_min = 0,
          .T_max = infinity,
          .edge = fmt::format("energies at or below q + P_inf (1/rho - b) are refused; {}tension is possible "
                              "down to -{:.6g} Pa, and c^2 > 0 everywhere",
                              p_.b > 0 ? fmt::format("towards rho = {:.6g} the pressure diverges; ", 1 / p_.b)
                                       : std::string(),
                              p_.P_inf)};
}

} // namespace mesobridge::fitting
