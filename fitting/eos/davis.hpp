#pragma once
#include "fitting/eos/described_eos.hpp"

namespace mesobridge::fitting {

/// Parameters of Davis, SI.
struct DavisParameters {
  double a;   ///< > 0: the adiabatic exponent rises by up to 2a in compression
  double b;   ///< < 1 + (k - 1)/(2a): part of that rise which Gamma does not follow
  double k;   ///< > 1: adiabatic exponent of the thin products
  double n;   ///< > 0: how suddenly it rises
  double v_c; ///< specific volume around which it does [m^3/kg]
  double p_c; ///< [Pa]
  double c_v; ///< [J/(kg K)]
  double m0;  ///< mass of one molecule of the explosive [kg]
};

/// Detonation products of PBX 9502 (Wescott, Stewart and Davis 2005); m0 is that of TATB, 95 % of it.
inline constexpr DavisParameters pbx_9502_products_parameters{.a = 0.798311,
                                                              .b = 0.58,
                                                              .k = 1.35,
                                                              .n = 2.66182,
                                                              .v_c = 7.5419e-4,
                                                              .p_c = 3.2e9,
                                                              .c_v = 1072,
                                                              .m0 = 258.15 * atomic_mass};

/// The equation of state of detonation products of Davis (Wescott, Stewart and Davis 2005; fitting/README.md,
/// Eq. (F22)), per unit mass, V = 1/(rho v_c), M = (V^n + V^-n)/2:
///   s = c_v ln[T/T_s],  T = T_s + (e - e_s)/c_v,  P = p_s + Gamma rho (e - e_s),
///   e_s = e_c M^(a/n) V^-(k-1+a),  p_s = rho e_s (k - 1 + F),  F = 2a V^-n/(V^n + V^-n),
///   Gamma = k - 1 + (1 - b) F,  T_s = T_c M^((1-b)a/n) V^-(k-1+(1-b)a),
///   e_c = p_c v_c/(k - 1 + a),  T_c = 2^(-ab/n) e_c/c_v: thin products are an ideal gas, whose e is c_v T.
class Davis : public DescribedEos<Davis, DavisParameters> {
 public:
  static constexpr std::string_view name = "Davis";
  static Description<Parameters> const& description();

  /// Throws InputError for a parameter out of its range.
  explicit Davis(Parameters const& parameters);

  template <class X>
  LinearLaw<X> law(X rho) const {
    using std::exp, std::log;
    auto const& p = p_;
    double const thin = p.k - 1, kept = 1 - p.b;
    X const L = -log(rho * p.v_c), sign = by_sign(L, 1, -1),
            z = exp(-2.0 * p.n * sign * L); // ln V, V^-2n or V^2n
    X const log_M = p.n * sign * L + log(0.5 * (1.0 + z));
    X const low = by_sign(L, 0, 1) + by_sign(L, 1, 0) * z, share = low / (1.0 + z); // V^-n/(V^n + V^-n)
    X const F = 2 * p.a * share, F_slope = 2 * p.n * F * (1.0 - share);             // dF/d ln rho
    X const e_s = e_c_ * exp(p.a / p.n * log_M - (thin + p.a) * L);
    X const phi = log_T_c_ + kept * p.a / p.n * log_M - (thin + kept * p.a) * L; // ln T_s
    X const heat = p.c_v * exp(phi), exponent = thin + F, Gamma = thin + kept * F;
    X const rho_Gamma_slope = Gamma + kept * F_slope;
    return {.E = e_s - heat,
            .P = rho * (e_s * exponent - heat * Gamma),
            .P_slope =
                e_s * (exponent * (1.0 + exponent) + F_slope) - heat * (rho_Gamma_slope + Gamma * Gamma),
            .Gamma = Gamma,
            .rho_Gamma_slope = rho_Gamma_slope,
            .phi = phi};
  }

  std::string edge() const;

 private:
  double e_c_, log_T_c_;
};

static_assert(EquationOfState<Davis>);

} // namespace mesobridge::fitting
