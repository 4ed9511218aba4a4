#pragma once
#include "fitting/eos/described_eos.hpp"

namespace mesobridge::fitting {

/// Parameters of MieGruneisen, SI.
struct MieGruneisenParameters {
  double Gamma_0;   ///< Gruneisen parameter at rho_0
  double Gamma_inf; ///< its limit at high compression
  double q;         ///< > 0: how fast it gets there
  double rho_0;     ///< [kg/m^3]
  double Theta_0;   ///< characteristic temperature at rho_0 [K]
  double u_r;       ///< temperature of the reference curve in units of Theta
  double c_v;       ///< [J/(kg K)]
  double rho_s;     ///< density of the reference curve's minimum [kg/m^3]
  double K_s;       ///< bulk modulus there [Pa]
  double N_s;       ///< > -1: pressure derivative of the bulk modulus
  double m0;        ///< mass of one atom [kg]
};

/// Molten tin under shock (thesis, Table 6.1), fitted there to a Hugoniot curve of an EAM potential.
inline constexpr MieGruneisenParameters tin_parameters{.Gamma_0 = 2.8,
                                                       .Gamma_inf = 0.43,
                                                       .q = 1.96,
                                                       .rho_0 = 7000,
                                                       .Theta_0 = 1150,
                                                       .u_r = 0.172,
                                                       .c_v = 173,
                                                       .rho_s = 6930,
                                                       .K_s = 4.19e10,
                                                       .N_s = 5.4,
                                                       .m0 = 118.71 * atomic_mass};

/// The Mie-Gruneisen equation of state (Heuze, C. R. Mecanique 340 (2012) 679; fitting/README.md,
/// Eq. (F4)), per unit mass:
///   s = c_v ln[1 + (e - E_k)/(c_v Theta u_r)],  hence T = Theta u_r + (e - E_k)/c_v,
///   P = P_k + Gamma rho (e - E_k),  P_k = K_s [exp((N_s+1) y) - 1]/(N_s+1),  y = 1 - rho_s/rho,
///   E_k = (K_s/rho_s) [exp((N_s+1) y)/(N_s+1)^2 - y/(N_s+1)],
///   Gamma = Gamma_inf + (Gamma_0 - Gamma_inf)(rho_0/rho)^q,
///   Theta = Theta_0 (rho/rho_0)^Gamma_inf exp[(Gamma_0 - Gamma_inf)/q (1 - (rho_0/rho)^q)].
class MieGruneisen : public DescribedEos<MieGruneisen, MieGruneisenParameters> {
 public:
  static constexpr std::string_view name = "Mie-Gruneisen";
  static Description<Parameters> const& description();

  /// Throws InputError for a parameter out of its range.
  explicit MieGruneisen(Parameters const& parameters);

  template <class X>
  LinearLaw<X> law(X rho) const {
    using std::exp, std::log;
    auto const& p = p_;
    double const n = p.N_s + 1, excess = p.Gamma_0 - p.Gamma_inf;
    X const y = 1.0 - p.rho_s / rho, F = exp(n * y);
    X const log_rho = log(rho / p.rho_0), power = excess * exp(-p.q * log_rho);
    X const Gamma = p.Gamma_inf + power, rho_Gamma_slope = Gamma - p.q * power;
    X const phi = log_Theta_ur_ + p.Gamma_inf * log_rho + (excess - power) / p.q;
    X const reference_heat = p.c_v * exp(phi); // c_v T_k
    return {.E = p.K_s / p.rho_s * (F / n - y) / n - reference_heat,
            .P = p.K_s * (F - 1.0) / n - rho * Gamma * reference_heat,
            .P_slope = p.K_s * F * p.rho_s / (rho * rho) - (rho_Gamma_slope + Gamma * Gamma) * reference_heat,
            .Gamma = Gamma,
            .rho_Gamma_slope = rho_Gamma_slope,
            .phi = phi};
  }

  std::string edge() const;

 private:
  double log_Theta_ur_;
};

static_assert(EquationOfState<MieGruneisen>);

} // namespace mesobridge::fitting
