#pragma once
#include "fitting/eos/described_eos.hpp"

namespace mesobridge::fitting {

/// Parameters of Hz, SI.
struct HzParameters {
  double Gamma_0; ///< Gruneisen parameter at rho_0
  double rho_0;   ///< density at (T_0, P_0) [kg/m^3]
  double c_0;     ///< velocity of sound on the reference curve at rho_0 [m/s]
  double s;       ///< >= 0: slope of the shock velocity over the particle velocity
  double c_v;     ///< [J/(kg K)]
  double T_0;     ///< standard temperature [K]
  double P_0;     ///< standard pressure [Pa]
  double m0;      ///< mass of one molecule [kg]
};

/// Unreacted nitromethane (thesis, Table 6.2).
inline constexpr HzParameters nitromethane_parameters{.Gamma_0 = 1,
                                                      .rho_0 = 1140,
                                                      .c_0 = 1358.47,
                                                      .s = 2.000184,
                                                      .c_v = 1211,
                                                      .T_0 = 298.13,
                                                      .P_0 = 1e5,
                                                      .m0 = 61.04 * atomic_mass};

/// The HZ equation of state (fitting/README.md, Eq. (F5)), per unit mass, x = 1 - rho_0/rho:
///   s = c_v ln[(e - E_ref)/c_v + theta] + c_v Gamma_0 rho_0/rho,  hence T = theta + (e - E_ref)/c_v,
///   P = rho^2 E_ref' + Gamma_0 rho_0 (e - E_ref),  theta = (T_0 - T_00) exp(Gamma_0 x),
///   E_ref = (c_0^2/2) x^2/(1 - s x) * {1 + s x/3 - s (Gamma_0 - s) x^2/6 for x >= 0; 1 for x < 0},
///   T_00 = P_0/(Gamma_0 rho_0 c_v).
/// At rho_0 the third derivative of E_ref jumps; P and its first derivatives are continuous.
class Hz : public DescribedEos<Hz, HzParameters> {
 public:
  static constexpr std::string_view name = "HZ";
  static Description<Parameters> const& description();

  /// Throws InputError for a parameter out of its range.
  explicit Hz(Parameters const& parameters);

  template <class X>
  LinearLaw<X> law(X rho) const {
    using std::exp;
    auto const& p = p_;
    X const v = p.rho_0 / rho, x = 1.0 - v, inverse = 1.0 / (1.0 - p.s * x);
    X const c3 = by_sign(x, p.s / 3, 0), c4 = by_sign(x, -p.s * (p.Gamma_0 - p.s) / 6, 0);
    // E_ref = (c_0^2/2) M/(1 - s x) and two derivatives with respect to x
    X const M = x * x * (1.0 + x * (c3 + c4 * x));
    X const M_1 = x * (2.0 + x * (3.0 * c3 + 4.0 * c4 * x));
    X const M_2 = 2.0 + x * (6.0 * c3 + 12.0 * c4 * x);
    X const g = M * inverse, g_1 = (M_1 + p.s * g) * inverse, g_2 = (M_2 + 2.0 * p.s * g_1) * inverse;
    double const half = 0.5 * p.c_0 * p.c_0;
    X const reference_heat = p.c_v * theta_0_ * exp(p.Gamma_0 * x); // c_v theta
    return {.E = half * g - reference_heat,
            .P = p.rho_0 * (half * g_1 - p.Gamma_0 * reference_heat),
            .P_slope = v * v * (half * g_2 - p.Gamma_0 * p.Gamma_0 * reference_heat),
            .Gamma = p.Gamma_0 * v,
            .rho_Gamma_slope = 0.0,
            .phi = -p.Gamma_0 * v};
  }

  /// rho_0 s/(s - 1): infinite pressure on the reference curve.
  double rho_max() const { return rho_max_; }
  /// Temperature of the reference curve at (T_0, P_0) below T_0 [K].
  double T_00() const { return p_.T_0 - theta_0_; }
  std::string edge() const;

 private:
  double theta_0_; // T_0 - T_00
  double rho_max_;
};

static_assert(EquationOfState<Hz>);

} // namespace mesobridge::fitting
