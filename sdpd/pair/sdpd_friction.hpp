#pragma once
#include "md/error.hpp"
#include "sdpd/pair/lane_math.hpp"

namespace mesobridge::sdpd {

/// What one exact Ornstein-Uhlenbeck step over dt does to the relative velocity of a pair in one direction:
/// v' = (1 + decay) v + kick() G, with G a standard Gaussian number (theory sheet, section 3, SSA). X is a
/// number or lanes of numbers.
template <class X>
struct OrnsteinUhlenbeck {
  X decay;    ///< alpha - 1 = exp(-2 gamma dt / m) - 1
  X variance; ///< zeta^2

  X kick() const { return square_root(variance); }
};

/// Friction and noise of an SDPD pair of equal masses m = 1 at one pair of temperatures (theory sheet,
/// Eq. 2.16). Friction gamma_theta = a_theta (1-d) and noise sigma_theta^2 = 4 a_theta k_B T_i T_j /
/// (T_i+T_j) come from the same numbers here and nowhere else, so that the fluctuation-dissipation relation
/// cannot be broken.
template <class X>
struct PairBath {
  X one_minus_d; ///< the factor that a finite heat capacity puts on the friction
  X thermal;     ///< 4 k_B T_i T_j / (T_i + T_j) / (1 - d) = sigma^2 / gamma

  PairBath(double boltzmann, X const& T_i, X const& T_j, X const& inverse_C_i, X const& inverse_C_j) {
    // d = m (1/C_i + 1/C_j) / s^2 with m = k_B T_i T_j, s = T_i + T_j; so written, the two divisions do not
    // wait for each other.
    X const m = constant<X>(boltzmann) * (T_i * T_j), s = T_i + T_j, s2 = s * s;
    X const rest = s2 - m * (inverse_C_i + inverse_C_j);
    one_minus_d = rest / s2;
    thermal = 4 * m * s / rest;
  }

  /// Both directions, along the pair with friction coefficient a_par and across it with a_perp.
  struct Directions {
    OrnsteinUhlenbeck<X> par, perp;
  };
  Directions step(X const& a_par, X const& a_perp, bool par_is_twice_perp, double dt) const {
    OrnsteinUhlenbeck<X> const across = step(a_perp, dt);
    if (!par_is_twice_perp)
      return {step(a_par, dt), across};
    return {of_decay(across.decay * (2 + across.decay)), across}; // exp(-2x) - 1 from exp(-x) - 1
  }

  /// One direction with friction coefficient `a` (without the factor 1-d) over the time dt.
  OrnsteinUhlenbeck<X> step(X const& a, double dt) const {
    return of_decay(minus_expm1(constant<X>(2 * dt) * a * one_minus_d));
  }

 private:
  OrnsteinUhlenbeck<X> of_decay(X const& decay) const { return {decay, thermal * -decay * (2 + decay)}; }
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
  template <class X>
  X perp(X const& chi) const {
    return constant<X>(perp_) * chi;
  }
  template <class X>
  X par(X const& chi) const {
    return constant<X>(par_) * chi;
  }

 private:
  double perp_, par_;
};

} // namespace mesobridge::sdpd
