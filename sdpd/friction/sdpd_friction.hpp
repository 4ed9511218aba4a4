#pragma once
#include "md/error.hpp"
#include "sdpd/friction/bath.hpp"

namespace mesobridge::sdpd {

/// The bath of an SDPD pair (sdpd/README.md, Eq. (S15)): friction gamma_theta = a_theta (1-d) and noise
/// sigma_theta^2 = 4 a_theta k_B T_i T_j / (T_i+T_j), where 1-d is the factor that a finite heat capacity
/// puts on the friction.
template <class X>
struct PairBath : Bath<X> {
  PairBath(double boltzmann, X const& T_i, X const& T_j, X const& inverse_C_i, X const& inverse_C_j) {
    // d = m (1/C_i + 1/C_j) / s^2 with m = k_B T_i T_j, s = T_i + T_j; so written, the two divisions do not
    // wait for each other.
    X const m = constant<X>(boltzmann) * (T_i * T_j), s = T_i + T_j, s2 = s * s;
    X const rest = s2 - m * (inverse_C_i + inverse_C_j);
    this->gamma_over_a = rest / s2;
    this->thermal = 4 * m * s / rest;
  }
};

/// The two friction coefficients of a fluid with shear viscosity eta and bulk viscosity zeta (reduced units):
/// a_perp = (5 eta/3 - zeta) chi and a_par = (10 eta/3 + 4 zeta) chi, chi = m_i m_j F_ij / (rho_i rho_j)
/// (Eq. (S14)).
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

/// The pair law of SDPD. Its weight is chi = F_ij / (rho_i rho_j); the invariant measure is
/// exp(S/k_B)/T for each particle.
struct SdpdLaw {
  static constexpr bool has_energies = true, measure_over_T = true;
  static constexpr Transverse across = Transverse::common;
  static constexpr PairNoise noise = PairNoise::vector;

  SdpdFriction friction;
  double boltzmann;

  template <class X>
  [[gnu::always_inline]] Bath<X> bath(PairTemperatures<X> const& at) const {
    return PairBath<X>(boltzmann, at.T_i, at.T_j, at.inverse_C_i, at.inverse_C_j);
  }
  template <class X>
  [[gnu::always_inline]] PairWeights<X> coefficients(PairWeights<X> const& weight) const {
    return {friction.par(weight.par), friction.perp(weight.par)};
  }
  bool par_is_twice_perp() const { return friction.par_is_twice_perp(); }
};

} // namespace mesobridge::sdpd
