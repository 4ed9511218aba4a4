#pragma once
#include "fitting/eos/concept.hpp"
#include "md/error.hpp"
#include <cmath>
#include <optional>

namespace mesobridge::fitting {

/// c^2 = (dP/drho)_T + T (dP/dT)_rho^2/(rho^2 c_v); negative where the fluid is mechanically unstable.
template <class I, class X>
X sound_speed_squared(I const& isochore, X T) {
  X const slope = isochore.pressure_slope(T) / isochore.density();
  return isochore.pressure_density_slope(T) + T * slope * slope / isochore.heat_capacity(T);
}

/// Everything a model says about one state, per unit mass, in the model's units.
struct EosState {
  double rho, T, e, P, s, c_v;
  double sound_speed_squared;        ///< < 0 inside the liquid-gas region
  std::optional<double> sound_speed; ///< absent there
  double gruneisen;                  ///< (dP/de)_rho / rho
  double free_energy;                ///< e - T s
  std::optional<double> alpha_r;     ///< A_res/(k_B T) per atom, for Lennard-Jones models
};

/// Throws PhysicsError that names the state where a quantity is no finite number, or so small that its digits
/// are lost: every model has such states.
inline EosState const& require_numbers(EosState const& state, std::string_view model) {
  auto const refuse = [&](std::string_view quantity, double value) {
    if (!std::isfinite(value) || std::fpclassify(value) == FP_SUBNORMAL)
      throw PhysicsError(
          fmt::format("{} at density {}, temperature {}: {} = {}; the state is too extreme for "
                      "double precision",
                      model, state.rho, state.T, quantity, value));
  };
  refuse("density", state.rho);
  refuse("temperature", state.T);
  refuse("energy", state.e);
  refuse("pressure", state.P);
  refuse("entropy", state.s);
  refuse("heat capacity", state.c_v);
  refuse("sound speed^2", state.sound_speed_squared);
  refuse("Gruneisen parameter", state.gruneisen);
  refuse("free energy", state.free_energy);
  refuse("alpha_r", state.alpha_r.value_or(0));
  return state;
}

/// Throws PhysicsError when the state is outside the model's domain, or so extreme that its numbers overflow.
template <EquationOfState E>
EosState state_from_temperature(E const& eos, double rho, double T) {
  double const e = eos.energy_from_temperature(T, rho);
  auto const isochore = eos.isochore(rho);
  double const s = isochore.entropy(T), c_v = isochore.heat_capacity(T);
  double const c_2 = sound_speed_squared(isochore, T);
  EosState state{.rho = rho,
                 .T = T,
                 .e = e,
                 .P = isochore.pressure(T),
                 .s = s,
                 .c_v = c_v,
                 .sound_speed_squared = c_2,
                 .sound_speed = std::nullopt,
                 .gruneisen = isochore.pressure_slope(T) / (rho * c_v),
                 .free_energy = e - T * s,
                 .alpha_r = std::nullopt};
  if (c_2 >= 0)
    state.sound_speed = std::sqrt(c_2);
  if constexpr (requires { eos.alpha_r(rho, T); })
    state.alpha_r = eos.alpha_r(rho, T);
  return require_numbers(state, E::name);
}

template <EquationOfState E>
EosState state_from_energy(E const& eos, double rho, double e) {
  return state_from_temperature(eos, rho, eos.temperature(e, rho));
}

template <EquationOfState E>
EosState state_from_entropy(E const& eos, double rho, double s) {
  return state_from_energy(eos, rho, eos.energy_from_entropy(s, rho));
}

} // namespace mesobridge::fitting
