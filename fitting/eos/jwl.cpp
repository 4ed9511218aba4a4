#include "fitting/eos/jwl.hpp"

namespace mesobridge::fitting {
namespace {

JwlParameters const& valid(JwlParameters const& p) {
  require_positive("JWL Gamma_0", p.Gamma_0);
  require_positive("JWL rho_0", p.rho_0);
  require_finite("JWL E_0", p.E_0);
  require_positive("JWL D_CJ", p.D_CJ);
  require(p.P_CJ > 0 && p.P_CJ < p.rho_0 * p.D_CJ * p.D_CJ, "JWL P_CJ", p.P_CJ,
          "must lie between 0 and rho_0 D_CJ^2");
  require_positive("JWL T_CJ", p.T_CJ);
  require_positive("JWL c_v", p.c_v);
  require_finite("JWL a", p.a);
  require_finite("JWL b", p.b);
  require_positive("JWL R_1", p.R_1);
  require_positive("JWL R_2", p.R_2);
  require_positive("JWL m0", p.m0);
  return p;
}

} // namespace

Jwl::Jwl(JwlParameters const& parameters) : p_(valid(parameters)), log_rho_0_(std::log(p_.rho_0)) {
  double const impedance = p_.rho_0 * p_.D_CJ * p_.D_CJ;
  rho_CJ_ = p_.rho_0 * impedance / (impedance - p_.P_CJ);
  double const v = p_.rho_0 / rho_CJ_, A = p_.a * std::exp(-p_.R_1 * v), B = p_.b * std::exp(-p_.R_2 * v);
  double const E_CJ = p_.E_0 + 0.5 * p_.P_CJ * (1 / p_.rho_0 - 1 / rho_CJ_);
  double const rest = p_.P_CJ - A - B; // of the pressure: the K term and the thermal part
  K_ = (rest - p_.c_v * p_.Gamma_0 * p_.T_CJ * rho_CJ_) * std::pow(v, p_.Gamma_0 + 1);
  C_ek_ = E_CJ - (A / p_.R_1 + B / p_.R_2) / p_.rho_0 - rest / (rho_CJ_ * p_.Gamma_0);
}

Domain Jwl::domain() const {
  double const infinity = std::numeric_limits<double>::infinity();
  return {.rho_min = 0,
          .rho_max = infinity,
          .T_min = 0,
          .T_max = infinity,
          .edge = fmt::format(
              "energies at or below the cold curve E_k(rho) are refused; K = {:.6g} Pa{}; in expansion the "
              "products become an ideal gas",
              K_,
              K_ < 0 ? " < 0 makes cold products mechanically unstable (no sound speed), at high density too"
                     : "")};
}

} // namespace mesobridge::fitting
