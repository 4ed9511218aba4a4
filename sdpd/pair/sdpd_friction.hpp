#pragma once
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::sdpd {

/// What one exact Ornstein-Uhlenbeck step over dt does to the relative velocity of a pair in one direction:
/// v' = (1 + decay) v + kick G, with G a standard Gaussian number (theory sheet, section 3, SSA).
struct OrnsteinUhlenbeck {
  double decay; ///< exp(-2 gamma dt / m) - 1
  double kick;  ///< the standard deviation zeta
};

/// exp(-x) - 1 for x >= 0 without cancellation. Up to 1 by the [7/6] Pade approximant of tanh(x/2), whose
/// error there is below round-off.
inline double minus_expm1(double x) {
  if (x > 1) [[unlikely]]
    return std::expm1(-x);
  double const y = 0.5 * x, z = y * y;
  double const numerator = y * (135135 + z * (17325 + z * (378 + z)));
  double const denominator = 135135 + z * (62370 + z * (3150 + 28 * z));
  return -2 * numerator / (denominator + numerator);
}

/// Friction and noise of an SDPD pair of equal masses m = 1 at one pair of temperatures (theory sheet,
/// Eq. 2.16). Friction gamma_theta = a_theta (1-d) and noise sigma_theta^2 = 4 a_theta k_B T_i T_j /
/// (T_i+T_j) come from the same numbers here and nowhere else, so that the fluctuation-dissipation relation
/// cannot be broken.
struct PairBath {
  double one_minus_d; ///< the factor that a finite heat capacity puts on the friction
  double thermal;     ///< 4 k_B T_i T_j / (T_i + T_j) / (1 - d) = sigma^2 / gamma

  PairBath(double boltzmann, double T_i, double T_j, double inverse_C_i, double inverse_C_j) {
    // d = m (1/C_i + 1/C_j) / s^2 with m = k_B T_i T_j, s = T_i + T_j; so written, the two divisions do not
    // wait for each other.
    double const m = boltzmann * T_i * T_j, s = T_i + T_j, s2 = s * s;
    double const rest = s2 - m * (inverse_C_i + inverse_C_j);
    one_minus_d = rest / s2;
    thermal = 4 * m * s / rest;
  }

  /// Both directions, along the pair with friction coefficient a_par and across it with a_perp.
  struct Directions {
    OrnsteinUhlenbeck par, perp;
  };
  Directions step(double a_par, double a_perp, bool par_is_twice_perp, double dt) const {
    OrnsteinUhlenbeck const perp = step(a_perp, dt);
    if (!par_is_twice_perp)
      return {step(a_par, dt), perp};
    double const decay = perp.decay * (2 + perp.decay); // exp(-2x) - 1 from exp(-x) - 1
    return {{decay, std::sqrt(thermal * -decay * (2 + decay))}, perp};
  }

  /// One direction with friction coefficient `a` (without the factor 1-d) over the time dt.
  OrnsteinUhlenbeck step(double a, double dt) const {
    double const decay = minus_expm1(2 * a * one_minus_d * dt);
    return {decay, std::sqrt(thermal * -decay * (2 + decay))};
  }
};

/// The two friction coefficients of a fluid with shear viscosity eta and bulk viscosity zeta (reduced units):
/// a_perp = (5 eta/3 - zeta) chi and a_par = (10 eta/3 + 4 zeta) chi, chi = m_i m_j F_ij / (rho_i rho_j)
/// (Eq. 1.33).
class SdpdFriction {
 public:
  SdpdFriction(double eta, double zeta) : perp_(5 * eta / 3 - zeta), par_(2 * (5 * eta / 3) + 4 * zeta) {
    require(eta >= 0 && std::isfinite(eta), "shear viscosity eta", eta, "must be >= 0");
    require(zeta >= 0 && perp_ >= 0, "bulk viscosity zeta", zeta,
            "must lie between 0 and 5 eta/3, or the transverse friction turns negative");
  }
  /// Without bulk viscosity a_par = 2 a_perp, which saves half of the exponentials.
  bool par_is_twice_perp() const { return par_ == 2 * perp_; }
  double perp(double chi) const { return perp_ * chi; }
  double par(double chi) const { return par_ * chi; }

 private:
  double perp_, par_;
};

} // namespace mesobridge::sdpd
