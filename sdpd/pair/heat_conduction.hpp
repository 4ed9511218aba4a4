#pragma once
#include "sdpd/pair/friction_shape.hpp"
#include <cmath>

namespace mesobridge::sdpd {

/// The law of the heat that one step over dt leads from j to i: a Gaussian number.
struct HeatStep {
  double mean, variance;
};

/// Conduction between SDPD particles of mass 1 (theory sheet, section 1):
///     d eps_i = K_ij (T_j - T_i) dt + (2 k_B K_ij T_i T_j)^(1/2) dW = -d eps_j,   K_ij = 2 kappa chi_ij,
/// with the weight chi_ij = F_ij/(rho_i rho_j) and the fluid's thermal conductivity kappa (reduced units,
/// > 0). Leaves f(eps_i + eps_j) exp((S_i + S_j)/k_B) / (T_i T_j) alone. Without noise, k_B = 0.
class SdpdConduction {
 public:
  static constexpr Across across = Across::none;
  static constexpr PairNoise noise = PairNoise::flow;

  SdpdConduction(double kappa, double boltzmann) : kappa_(kappa), boltzmann_(boltzmann) {
    require(kappa > 0 && std::isfinite(kappa), "thermal conductivity kappa", kappa, "must be > 0");
  }
  double boltzmann() const { return boltzmann_; }

  /// The exact step at frozen heat capacities and noise: then T_j - T_i is an Ornstein-Uhlenbeck process that
  /// decays by exp(-K_ij c dt), c = 1/C_i + 1/C_j, so that no dt carries it past zero in the mean and a long
  /// one leads to the spread of the pair's equilibrium.
  HeatStep step(double chi, double dt, PairTemperatures<double> const& at) const {
    double const c = at.inverse_C_i + at.inverse_C_j;
    double const decay = std::expm1(-2 * kappa_ * chi * c * dt);
    return {(at.T_i - at.T_j) * decay / c, boltzmann_ * at.T_i * at.T_j * -decay * (2 + decay) / c};
  }
  /// The particle's part of the logarithm of the invariant measure, beside S/k_B.
  static double log_measure(double T) { return -std::log(T); }

 private:
  double kappa_, boltzmann_;
};

/// Conduction between DPDE particles, driven by the inverse temperatures (theory sheet, section 1):
///     d eps_i = w (1/T_i - 1/T_j) dt + (2 k_B w)^(1/2) dW = -d eps_j
/// with a weight w >= 0, kappa chi^2, of the pair's distance. Leaves f(eps_i + eps_j) exp((S_i + S_j)/k_B)
/// alone.
struct DpdeConduction {
  static constexpr Across across = Across::none;
  static constexpr PairNoise noise = PairNoise::flow;

  AnyFrictionShape shape; ///< w as the friction along the line of centres
  double k_B;

  double boltzmann() const { return k_B; }

  /// As for SDPD, with 1/T_i - 1/T_j for the Ornstein-Uhlenbeck process and c = 1/(T_i^2 C_i) + 1/(T_j^2
  /// C_j).
  HeatStep step(double weight, double dt, PairTemperatures<double> const& at) const {
    double const c = at.inverse_C_i / (at.T_i * at.T_i) + at.inverse_C_j / (at.T_j * at.T_j);
    double const decay = std::expm1(-weight * c * dt);
    return {(1 / at.T_j - 1 / at.T_i) * decay / c, k_B * -decay * (2 + decay) / c};
  }
  static double log_measure(double) { return 0; }
};

/// Nothing, or a law of conduction.
using AnyConduction = std::variant<std::monostate, SdpdConduction, DpdeConduction>;

} // namespace mesobridge::sdpd
