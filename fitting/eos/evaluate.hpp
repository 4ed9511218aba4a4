#pragma once
#include "fitting/eos/concept.hpp"
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

/// Throws PhysicsError when the state is outside the model's domain.
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
  return state;
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
