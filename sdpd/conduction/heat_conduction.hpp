#pragma once
#include "sdpd/friction/friction_shape.hpp"
#include <cmath>

namespace mesobridge::sdpd {

/// The law of the heat that one step over dt leads from j to i: a Gaussian number. X is a number or lanes of
/// numbers.
template <class X>
struct HeatStep {
  X mean, variance;
};

/// Conduction between SDPD particles of mass 1 (sdpd/README.md, Eq. (S20)):
///     d eps_i = K_ij (T_j - T_i) dt + (2 k_B K_ij T_i T_j)^(1/2) dW = -d eps_j,   K_ij = 2 kappa chi_ij,
/// with the weight chi_ij = F_ij/(rho_i rho_j) and the fluid's thermal conductivity kappa (reduced units,
/// > 0). Leaves f(eps_i + eps_j) exp((S_i + S_j)/k_B) / (T_i T_j) alone. Without noise, k_B = 0.
struct SdpdConduction {
  static constexpr bool has_energies = true, measure_over_T = true;
  static constexpr Transverse across = Transverse::none;
  static constexpr PairNoise noise = PairNoise::flow;

  double kappa, boltzmann;

  /// The exact step at frozen heat capacities and noise: then T_j - T_i is an Ornstein-Uhlenbeck process that
  /// decays by exp(-K_ij c dt), c = 1/C_i + 1/C_j, so that no dt carries it past zero in the mean and a long
  /// one leads to the spread of the pair's equilibrium. `difference` is T_i - T_j, which may be known more
  /// exactly than the temperatures.
  template <class X>
  [[gnu::always_inline]] HeatStep<X> step(X const& chi, double dt, PairTemperatures<X> const& at,
                                          X const& difference) const {
    X const c = at.inverse_C_i + at.inverse_C_j;
    X const decay = minus_expm1(constant<X>(2 * kappa * dt) * chi * c), share = decay / c;
    return {difference * share, constant<X>(-boltzmann) * at.T_i * at.T_j * share * (2 + decay)};
  }
};

/// Conduction between DPDE particles, driven by the inverse temperatures (sdpd/README.md, Eq. (S21)):
///     d eps_i = w (1/T_i - 1/T_j) dt + (2 k_B w)^(1/2) dW = -d eps_j
/// with a weight w >= 0, kappa chi^2, of the pair's distance. Leaves f(eps_i + eps_j) exp((S_i + S_j)/k_B)
/// alone.
struct DpdeConduction {
  static constexpr bool has_energies = true, measure_over_T = false;
  static constexpr Transverse across = Transverse::none;
  static constexpr PairNoise noise = PairNoise::flow;

  AnyWeightFunction shape; ///< w as the friction along the line of centres
  double boltzmann;

  /// As for SDPD, with 1/T_i - 1/T_j for the Ornstein-Uhlenbeck process and c = 1/(T_i^2 C_i) + 1/(T_j^2
  /// C_j).
  template <class X>
  [[gnu::always_inline]] HeatStep<X> step(X const& weight, double dt, PairTemperatures<X> const& at,
                                          X const& difference) const {
    X const beta_i = 1 / at.T_i, beta_j = 1 / at.T_j;
    X const c = at.inverse_C_i * (beta_i * beta_i) + at.inverse_C_j * (beta_j * beta_j);
    X const decay = minus_expm1(constant<X>(dt) * weight * c), share = decay / c;
    return {difference * (beta_i * beta_j) * share, constant<X>(-boltzmann) * share * (2 + decay)};
  }
};

/// Nothing, or a law of conduction.
using AnyConduction = std::variant<std::monostate, SdpdConduction, DpdeConduction>;

} // namespace mesobridge::sdpd
