#pragma once
#include "fitting/eos/from_free_energy.hpp"
#include <numbers>

namespace mesobridge::fitting {

/// The equation of state of Kolafa and Nezbeda, Fluid Phase Equilib. 100, 1 (1994), for the whole
/// Lennard-Jones fluid up to T* = 20: independent of the BWR form and, unlike the 1993 coefficients of that
/// (fitted up to T* = 6), good in all of the default region. Residual Helmholtz energy per atom, Eqs.
/// (26)-(30): hard spheres, the second virial coefficient and a sum C_ij T^(i/2) rho^j.
struct KolafaNezbeda {
  static constexpr std::string_view name = "Kolafa-Nezbeda";
  static constexpr double T_max = 20, rho_max = 1.25;
  static constexpr double T_min(double /*rho*/) { return 0.68; }
  static constexpr std::string_view edge =
      "made from simulations at 0.68 <= T* <= 10 and virial coefficients to T* = 20; other states are "
      "refused; "
      "inside the liquid-gas region the fluid is mechanically unstable (no sound speed)";

  /// Not inlined: it is long, and every function of an isochore calls it.
  template <class X>
  [[gnu::noinline]] static X residual(X const& rho, X const& T) {
    using std::exp, std::log, std::sqrt;
    X const i = 1.0 / sqrt(T), i_2 = i * i, rho_2 = rho * rho;
    X const d =
        -0.063920968 * log(T) + 0.011117524 * i_2 - 0.076383859 * i + 1.080142248 + 0.000693129 * (T * i);
    X const eta = std::numbers::pi / 6 * (rho * d * d * d), space = 1.0 - eta;
    X const spheres =
        5.0 / 3 * log(space) + eta * (34.0 + eta * (4.0 * eta - 33.0)) / (6.0 * (space * space));
    X const virial =
        (((((-0.58544978 * i + 0.43102052) * i + 0.87361369) * i - 4.13749995) * i + 2.90616279) * i -
         7.02181962) *
            i_2 +
        0.02459877;
    X const at_0 = 2.01546797 + rho * (-28.17881636 + rho * (28.28313847 + rho * -10.42402873));
    X const at_1 =
        -19.58371655 + rho * (75.62340289 + rho * (-120.70586598 + rho * (93.92740328 + rho * -27.37737354)));
    X const at_2 = 29.34470520 +
                   rho * (-112.35356937 + rho * (170.64908980 + rho * (-123.06669187 + rho * 34.42288969)));
    X const at_4 =
        -13.37031968 + rho * (65.38059570 + rho * (-115.09233113 + rho * (88.91973082 + rho * -25.62099890)));
    return T * (spheres + rho * virial * exp(-1.92907278 * rho_2)) +
           rho_2 * (at_0 + i * (at_1 + i * (at_2 + i_2 * at_4)));
  }
};

using LjKolafaNezbeda = FromFreeEnergy<KolafaNezbeda>;
static_assert(EquationOfState<LjKolafaNezbeda>);

/// Pressure in Lennard-Jones units; unlike LjKolafaNezbeda's it asks for no domain.
inline double kolafa_nezbeda_pressure(double rho, double T) {
  return BasicFreeEnergyIsochore<KolafaNezbeda, double>({}, rho).pressure(T);
}

/// Residual energy per atom; the whole energy is 3T/2 more.
inline double kolafa_nezbeda_energy(double rho, double T) {
  return BasicFreeEnergyIsochore<KolafaNezbeda, double>({}, rho).energy(T) - 1.5 * T;
}

inline double kolafa_nezbeda_heat_capacity(double rho, double T) {
  return BasicFreeEnergyIsochore<KolafaNezbeda, double>({}, rho).heat_capacity(T);
}

} // namespace mesobridge::fitting
