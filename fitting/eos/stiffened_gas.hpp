#pragma once
#include "fitting/eos/described_eos.hpp"

namespace mesobridge::fitting {

/// Parameters of StiffenedGas, SI.
struct StiffenedGasParameters {
  double gamma; ///< > 1
  double P_inf; ///< >= 0: stiffness [Pa]
  double c_v;   ///< [J/(kg K)]
  double q;     ///< zero of the energy [J/kg]
  double m0;    ///< mass of one molecule [kg]
  double b = 0; ///< >= 0: covolume, which no pressure takes away [m^3/kg]
};

/// Liquid water: gamma, c_v and q by Le Metayer and Saurel, Phys. Fluids 28 (2016) 046102 (300 to 500 K along
/// the saturation curve); P_inf and b follow from P = 0.1 MPa and c = 1500 m/s at 997 kg/m^3 and 300 K.
inline constexpr StiffenedGasParameters water_parameters{
    .gamma = 1.19, .P_inf = 6.2178e8, .c_v = 3610, .q = -1177788, .m0 = 18.015 * atomic_mass, .b = 6.7212e-4};

/// Dry air as an ideal gas whose rotations are free and whose vibrations are frozen: c_v = (5/2) k_B/m0.
inline constexpr double air_molecule = 28.96 * atomic_mass;
inline constexpr StiffenedGasParameters air_parameters{
    .gamma = 1.4, .P_inf = 0, .c_v = 2.5 * k_B / air_molecule, .q = 0, .m0 = air_molecule};

/// The stiffened gas of Noble and Abel (an ideal gas under the inner pressure P_inf, of molecules that take
/// the volume b; b = 0: the plain stiffened gas; fitting/README.md, Eq. (F7)), per unit mass, v = 1/rho:
///   e = q + c_v T + P_inf (v - b),  P = (gamma - 1)(e - q)/(v - b) - gamma P_inf,
///   s = c_v [ln T + (gamma - 1) ln(v - b)],  c^2 = gamma v^2 (P + P_inf)/(v - b).
/// The logarithms are of the numbers in K and m^3/kg.
class StiffenedGas : public DescribedEos<StiffenedGas, StiffenedGasParameters> {
 public:
  static constexpr std::string_view name = "stiffened gas";
  static Description<Parameters> const& description();

  using DescribedEos::DescribedEos;

  template <class X>
  LinearLaw<X> law(X rho) const {
    using std::log;
    double const Gamma = p_.gamma - 1;
    X const free = 1.0 - p_.b * rho; // part of the volume that is not the molecules' own
    return {.E = p_.q + p_.P_inf / rho - p_.P_inf * p_.b,
            .P = -p_.P_inf,
            .P_slope = 0.0,
            .Gamma = Gamma / free,
            .rho_Gamma_slope = Gamma / (free * free),
            .phi = Gamma * log(rho / free)};
  }

  double rho_max() const { return p_.b > 0 ? 1 / p_.b : std::numeric_limits<double>::infinity(); }
  std::string edge() const;
};

static_assert(EquationOfState<StiffenedGas>);

} // namespace mesobridge::fitting
