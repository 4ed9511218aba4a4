#include "fitting/state_at_pressure.hpp"
#include "fitting/root.hpp"
#include <cmath>

namespace mesobridge::fitting {

EosState state_at_pressure(Fluid const& fluid, double rho, double P) {
  require(rho > 0 && std::isfinite(rho), "density", rho, "must be > 0 and finite");
  require(std::isfinite(P), "pressure", P, "must be finite");
  constexpr double coldest = 1e-6, hottest = 1e12, ratio = 1.5; // wherever a model has no edge of its own
  auto const domain = fluid.domain();
  double const first = std::max(domain.T_min, coldest), last = std::min(domain.T_max, hottest);
  auto const excess = [&](double T) { return fluid.at_temperature(rho, T).P - P; };
  if (auto const T = first_rising_zero(excess, first, last, ratio))
    return fluid.at_temperature(rho, *T);
  throw PhysicsError(fmt::format("no state of density {:.6g} between temperatures {:.4g} and {:.4g} has the "
                                 "pressure {:.6g}",
                                 rho, first, last, P));
}

} // namespace mesobridge::fitting
