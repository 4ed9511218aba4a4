#pragma once
#include "fitting/eos/described_eos.hpp"

namespace mesobridge::fitting {

/// Parameters of Jwl, SI. The Chapman-Jouguet state fixes the two constants K and C_ek.
struct JwlParameters {
  double Gamma_0;  ///< Gruneisen parameter
  double rho_0;    ///< density of the unreacted explosive [kg/m^3]
  double E_0;      ///< its energy [J/kg]
  double D_CJ;     ///< detonation velocity [m/s]
  double P_CJ;     ///< [Pa], < rho_0 D_CJ^2
  double T_CJ;     ///< [K]
  double c_v;      ///< [J/(kg K)]
  double a, b;     ///< [Pa]
  double R_1, R_2; ///< > 0
  double m0;       ///< mass of one molecule of the explosive [kg]
};

/// Detonation products of nitromethane (thesis, Table 6.3).
inline constexpr JwlParameters nitromethane_products_parameters{.Gamma_0 = 0.3,
                                                                .rho_0 = 1128,
                                                                .E_0 = 0,
                                                                .D_CJ = 6280,
                                                                .P_CJ = 1.25e10,
                                                                .T_CJ = 3000,
                                                                .c_v = 2764.23,
                                                                .a = 2.092e11,
                                                                .b = 5.689e9,
                                                                .R_1 = 4.4,
                                                                .R_2 = 1.2,
                                                                .m0 = 61.04 * atomic_mass};

/// The Jones-Wilkins-Lee equation of state of detonation products (fitting/README.md, Eq. (F6), where the
/// 1/m that the thesis prints in K is corrected), per unit mass, v = rho_0/rho:
///   s = c_v ln[(e - E_k)/c_v] - c_v Gamma_0 ln rho,  hence T = (e - E_k)/c_v,
///   P = P_k + Gamma_0 rho (e - E_k),  P_k = a exp(-R_1 v) + b exp(-R_2 v) + K v^-(Gamma_0+1),
///   E_k = [a exp(-R_1 v)/R_1 + b exp(-R_2 v)/R_2 + K v^-Gamma_0/Gamma_0]/rho_0 + C_ek.
/// The logarithm of the density is of the number in kg/m^3.
class Jwl : public DescribedEos<Jwl, JwlParameters> {
 public:
  static constexpr std::string_view name = "JWL";
  static Description<Parameters> const& description();

  /// Throws InputError for a parameter out of its range.
  explicit Jwl(Parameters const& parameters);

  template <class X>
  LinearLaw<X> law(X rho) const {
    using std::exp, std::log;
    auto const& p = p_;
    X const v = p.rho_0 / rho, log_rho = log(rho);
    X const A = p.a * exp(-p.R_1 * v), B = p.b * exp(-p.R_2 * v);
    X const power = K_ * exp(p.Gamma_0 * (log_rho - log_rho_0_)); // K v^-Gamma_0
    return {.E = (A / p.R_1 + B / p.R_2 + power / p.Gamma_0) / p.rho_0 + C_ek_,
            .P = A + B + power / v,
            .P_slope = (v * (A * p.R_1 + B * p.R_2) + (p.Gamma_0 + 1) * power / v) / rho,
            .Gamma = p.Gamma_0,
            .rho_Gamma_slope = p.Gamma_0,
            .phi = p.Gamma_0 * log_rho};
  }

  double rho_CJ() const { return rho_CJ_; }
  double K() const { return K_; }       ///< [Pa]
  double C_ek() const { return C_ek_; } ///< [J/kg]
  std::string edge() const;

 private:
  double log_rho_0_, rho_CJ_, K_, C_ek_;
};

static_assert(EquationOfState<Jwl>);

} // namespace mesobridge::fitting
