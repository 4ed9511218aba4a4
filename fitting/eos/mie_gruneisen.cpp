#include "fitting/eos/mie_gruneisen.hpp"

namespace mesobridge::fitting {

MieGruneisen::MieGruneisen(MieGruneisenParameters const& p)
    : p_(p), log_Theta_ur_(std::log(p.Theta_0 * p.u_r)) {
  require_positive("Mie-Gruneisen Gamma_0", p.Gamma_0);
  require(p.Gamma_inf >= 0 && std::isfinite(p.Gamma_inf), "Mie-Gruneisen Gamma_inf", p.Gamma_inf,
          "must be >= 0 and finite");
  require_positive("Mie-Gruneisen q", p.q);
  require_positive("Mie-Gruneisen rho_0", p.rho_0);
  require_positive("Mie-Gruneisen Theta_0", p.Theta_0);
  require_positive("Mie-Gruneisen u_r", p.u_r);
  require_positive("Mie-Gruneisen c_v", p.c_v);
  require_positive("Mie-Gruneisen rho_s", p.rho_s);
  require_positive("Mie-Gruneisen K_s", p.K_s);
  require(p.N_s > -1 && std::isfinite(p.N_s), "Mie-Gruneisen N_s", p.N_s, "must be > -1 and finite");
  require_positive("Mie-Gruneisen m0", p.m0);
}

Domain MieGruneisen::domain() const {
  double const infinity = std::numeric_limits<double>::infinity();
  return {
      .rho_min = 0,
      .rho_max = infinity,
      .T_min = 0,
      .T_max = infinity,
      .edge = fmt::format(
          "energies at or below that of T = 0 are refused; in expansion the reference curve pulls with at "
          "most {:.4g} Pa while Gamma grows like rho^-{:.4g}: beyond the isothermal spinodal, where P(rho) "
          "at constant T has its minimum, P rises again and the model is neither liquid nor vapour; in "
          "compression the reference pressure stays below {:.4g} Pa",
          p_.K_s / (p_.N_s + 1), p_.q, p_.K_s * std::expm1(p_.N_s + 1) / (p_.N_s + 1))};
}

} // namespace mesobridge::fitting
