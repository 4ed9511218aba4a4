#include "fitting/eos/hz.hpp"

namespace mesobridge::fitting {

Hz::Hz(HzParameters const& p)
    : p_(p), theta_0_(p.T_0 - p.P_0 / (p.Gamma_0 * p.rho_0 * p.c_v)),
      rho_max_(p.s > 1 ? p.rho_0 * p.s / (p.s - 1) : std::numeric_limits<double>::infinity()) {
  require_positive("HZ Gamma_0", p.Gamma_0);
  require_positive("HZ rho_0", p.rho_0);
  require_positive("HZ c_0", p.c_0);
  require(p.s >= 0 && std::isfinite(p.s), "HZ s", p.s, "must be >= 0 and finite");
  require_positive("HZ c_v", p.c_v);
  require_positive("HZ T_0", p.T_0);
  require_finite("HZ P_0", p.P_0);
  require(theta_0_ > 0, "HZ T_0 - P_0/(Gamma_0 rho_0 c_v)", theta_0_, "must be > 0");
  require_positive("HZ m0", p.m0);
}

Domain Hz::domain() const {
  double const infinity = std::numeric_limits<double>::infinity();
  return {
      .rho_min = 0,
      .rho_max = rho_max_,
      .T_min = 0,
      .T_max = infinity,
      .edge = fmt::format(
          "energies at or below that of T = 0 are refused; {}; below rho = {:.6g} the reference curve is "
          "in tension, and states colder than it turn mechanically unstable in expansion (no sound speed)",
          std::isfinite(rho_max_)
              ? fmt::format("towards rho = {:.6g} the reference pressure diverges", rho_max_)
              : std::string("no compression is too high"),
          p_.rho_0)};
}

} // namespace mesobridge::fitting
