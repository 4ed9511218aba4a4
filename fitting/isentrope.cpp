#include "fitting/isentrope.hpp"
#include "fitting/quadrature.hpp"
#include "fitting/root.hpp"
#include <algorithm>

namespace mesobridge::fitting {

Isentrope::Isentrope(Fluid fluid, EosState const& from) : fluid_(std::move(fluid)), from_(from) {}

EosState Isentrope::at_density(double rho) const {
  return fluid_.at_entropy(rho, from_.s);
}

EosState Isentrope::at_pressure(double P) const {
  require(std::isfinite(P), "pressure on the isentrope", P, "must be finite");
  if (P == from_.P)
    return from_;
  bool const compress = P > from_.P;
  double const direction = compress ? 1 : -1;
  auto const excess = [&](double rho) { return direction * (at_density(rho).P - P); };
  constexpr double step_ratio = 1.1, farthest = 1e30;
  double const last = compress ? std::min(fluid_.domain().rho_max, farthest * from_.rho)
                               : std::max(fluid_.domain().rho_min, from_.rho / farthest);
  auto const rho = first_rising_zero(excess, from_.rho, last, step_ratio);
  if (!rho)
    throw PhysicsError(
        fmt::format("the isentrope through density {}, temperature {} does not reach pressure {} "
                    "inside the model; {}",
                    from_.rho, from_.T, P, fluid_.domain().edge));
  auto const found = at_density(*rho);
  if (!found.sound_speed)
    throw PhysicsError(
        fmt::format("the isentrope through density {}, temperature {} is mechanically unstable at "
                    "pressure {} (density {})",
                    from_.rho, from_.T, P, found.rho));
  return found;
}

double Isentrope::velocity_change(double rho_a, double rho_b) const {
  auto const sound_speed = [&](double log_rho) {
    auto const state = at_density(std::exp(log_rho));
    if (!state.sound_speed)
      throw PhysicsError(
          fmt::format("the isentrope through density {}, temperature {} is mechanically unstable "
                      "at density {}",
                      from_.rho, from_.T, state.rho));
    return *state.sound_speed;
  };
  return integral(sound_speed, std::log(rho_a), std::log(rho_b));
}

} // namespace mesobridge::fitting
