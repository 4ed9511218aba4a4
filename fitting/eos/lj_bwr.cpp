#include "fitting/eos/lj_bwr.hpp"
#include "fitting/eos/evaluate.hpp"
#include "md/error.hpp"

namespace mesobridge::fitting {

LjBwr::LjBwr(LjBwrSet const& set, std::optional<LjUnits> units)
    : set_(set), matrix_(set.x), units_(units), scale_(LjScale::of(units)),
      rho_max_(set.rho_max * scale_.density) {
  for (int j = 0; j < bwr::parameters; ++j)
    require(std::isfinite(set.x[j]), fmt::format("LJ-BWR x{}", j + 1), set.x[j], "must be finite");
  require(set.gamma > 0 && std::isfinite(set.gamma), "LJ-BWR gamma", set.gamma, "must be > 0");
  require(set.T_low > 0 && std::isfinite(set.T_low), "LJ-BWR T_low*", set.T_low, "must be > 0");
  require(set.T_max > set.T_low && std::isfinite(set.T_max), "LJ-BWR T_max*", set.T_max, "must be > T_low*");
  require(set.rho_max > 0 && std::isfinite(set.rho_max), "LJ-BWR rho_max*", set.rho_max, "must be > 0");
}

double LjBwr::entropy(double e, double rho) const {
  return isochore(rho).entropy(temperature(e, rho));
}
double LjBwr::pressure(double e, double rho) const {
  return isochore(rho).pressure(temperature(e, rho));
}
double LjBwr::heat_capacity(double e, double rho) const {
  return isochore(rho).heat_capacity(temperature(e, rho));
}

double LjBwr::sound_speed(double e, double rho) const {
  double const T = temperature(e, rho), c_2 = sound_speed_squared(isochore(rho), T);
  if (!(c_2 >= 0))
    throw PhysicsError(
        fmt::format("LJ-BWR at density {}, temperature {}: the fluid is mechanically unstable, "
                    "sound speed^2 = {}",
                    rho, T, c_2));
  return std::sqrt(c_2);
}

double LjBwr::energy_from_entropy(double s, double rho) const {
  auto const at_rho = isochore(rho);
  return at_rho.energy(at_rho.temperature_from_entropy(s, scale_.temperature));
}

double LjBwr::energy_from_temperature(double T, double rho) const {
  require_temperature(T, rho);
  return isochore(rho).energy(T);
}

double LjBwr::alpha_r(double rho, double T) const {
  require_temperature(T, rho);
  return isochore(rho).residual_free_energy(T) / (scale_.specific_entropy() * T);
}

Domain LjBwr::domain() const {
  return {.rho_min = 0,
          .rho_max = rho_max_,
          .T_min = 0,
          .T_max = set_.T_max * scale_.temperature,
          .edge = fmt::format(
              "below T = {:.6g} the heat capacity is that of T = {:.6g}; other states are refused",
              set_.T_low * scale_.temperature, set_.T_low * scale_.temperature)};
}

void LjBwr::refuse_density(double rho) const {
  throw PhysicsError(fmt::format("LJ-BWR: density {} (rho* = {:.6g}) is outside 0 < rho* <= {}", rho,
                                 rho / scale_.density, set_.rho_max));
}

void LjBwr::require_temperature(double T, double rho) const {
  if (!(T > 0 && T <= set_.T_max * scale_.temperature))
    throw PhysicsError(
        fmt::format("LJ-BWR at density {}: temperature {} (T* = {:.6g}) is outside 0 < T* <= {}", rho, T,
                    T / scale_.temperature, set_.T_max));
}

} // namespace mesobridge::fitting
