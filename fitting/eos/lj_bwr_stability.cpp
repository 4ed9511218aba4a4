#include "fitting/eos/lj_bwr_stability.hpp"
#include "fitting/eos/evaluate.hpp"
#include <limits>

namespace mesobridge::fitting {
namespace {

/// Whether the two terms of c^2 = (dP/drho)_T + T (dP/dT)^2/(rho^2 c_v) leave a clearly positive sum.
bool clearly_stable(LjBwrIsochore const& isochore, double T) {
  double const c_2 = sound_speed_squared(isochore, T), isothermal = isochore.pressure_density_slope(T);
  return c_2 > 0.2 * (std::abs(isothermal) + std::abs(c_2 - isothermal));
}

} // namespace

LjStability stability(LjBwrSet const& set, LjRegion const& region) {
  bwr::Matrix const M(set.x), published(lj_bwr_1993.x);
  LjStability found{.c_v_min = std::numeric_limits<double>::infinity(),
                    .rho_at_c_v_min = 0,
                    .T_at_c_v_min = 0,
                    .unstable = 0,
                    .rho_unstable = 0,
                    .T_unstable = 0,
                    .states = 0};
  for_each_state(region, 126, 80, [&](double rho, double T) {
    LjBwrIsochore const fitted(set, M, {}, rho), reference(lj_bwr_1993, published, {}, rho);
    ++found.states;
    double const c_v = fitted.heat_capacity(T);
    if (!(c_v >= found.c_v_min)) {
      found.c_v_min = c_v;
      found.rho_at_c_v_min = rho;
      found.T_at_c_v_min = T;
    }
    if (clearly_stable(reference, T) && !(sound_speed_squared(fitted, T) > 0)) {
      ++found.unstable;
      found.rho_unstable = rho;
      found.T_unstable = T;
    }
  });
  return found;
}

} // namespace mesobridge::fitting
