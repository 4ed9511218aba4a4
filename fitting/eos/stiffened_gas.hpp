#pragma once
#include "fitting/eos/linear_isochore.hpp"

namespace mesobridge::fitting {

/// Parameters of StiffenedGas, SI.
struct StiffenedGasParameters {
  double gamma; ///< > 1
  double P_inf; ///< >= 0: stiffness [Pa]
  double c_v;   ///< [J/(kg K)]
  double q;     ///< zero of the energy [J/kg]
  double m0;    ///< mass of one molecule [kg]
};

/// Liquid water between 298 and 473 K: Le Metayer, Massoni, Saurel, Int. J. Therm. Sci. 43 (2004) 265.
inline constexpr StiffenedGasParameters water_parameters{
    .gamma = 2.35, .P_inf = 1e9, .c_v = 1816, .q = -1.167e6, .m0 = 18.015 * atomic_mass};

/// The stiffened gas (an ideal gas under the inner pressure P_inf), per unit mass:
///   e = q + c_v T + P_inf/rho,  P = (gamma - 1) rho (e - q) - gamma P_inf,
///   s = c_v [ln T - (gamma - 1) ln rho],  c^2 = gamma (P + P_inf)/rho.
/// The logarithms are of the numbers in K and kg/m^3.
class StiffenedGas : public LinearEos<StiffenedGas> {
 public:
  static constexpr std::string_view name = "stiffened gas";

  /// Throws InputError for a parameter out of its range.
  explicit StiffenedGas(StiffenedGasParameters const& parameters);

  template <class X>
  LinearLaw<X> law(X rho) const {
    using std::log;
    double const Gamma = p_.gamma - 1;
    return {.E = p_.q + p_.P_inf / rho,
            .P = -p_.P_inf,
            .P_slope = 0.0,
            .Gamma = Gamma,
            .rho_Gamma_slope = Gamma,
            .phi = Gamma * log(rho)};
  }

  double c_v() const { return p_.c_v; }
  double rho_max() const { return std::numeric_limits<double>::infinity(); }
  double molecular_mass() const { return p_.m0; }
  double boltzmann() const { return k_B; }
  StiffenedGasParameters const& parameters() const { return p_; }
  Domain domain() const;

 private:
  StiffenedGasParameters p_;
};

static_assert(EquationOfState<StiffenedGas>);

} // namespace mesobridge::fitting
