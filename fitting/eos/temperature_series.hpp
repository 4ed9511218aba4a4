#pragma once
#include "fitting/simd/pack.hpp"
#include <array>
#include <cmath>
#include <complex>
#include <type_traits>

namespace mesobridge::fitting {

inline double real_part(double x) {
  return x;
}
inline double real_part(std::complex<double> x) {
  return x.real();
}

/// A free energy at one density as a short sum of powers of temperature,
///   A(T) = c0 T + c1 sqrt(T) + c2 + c3/T + c4/T^2 + c5/T^3 + c6/T^4,
/// and its derivatives by hand. The BWR equation with its 32 parameters is of this form at fixed density, and
/// so are rho^2 dA/drho (whose "value" is the pressure, and minus its "entropy" is dP/dT) and d/drho of that.
template <class X>
struct TemperatureSeries {
  static constexpr int terms = 8; ///< padded to the vector width: the last coefficient stays zero
  std::array<X, terms> c{};

  X value(X T) const {
    using std::sqrt;
    X const t = 1.0 / T;
    return c[0] * T + c[1] * sqrt(T) + c[2] + t * (c[3] + t * (c[4] + t * (c[5] + t * c[6])));
  }
  /// -dA/dT
  X entropy(X T) const {
    using std::sqrt;
    X const t = 1.0 / T;
    return t * t * (c[3] + t * (2.0 * c[4] + t * (3.0 * c[5] + t * (4.0 * c[6])))) - c[0] -
           0.5 * c[1] * t * sqrt(T);
  }
  /// A - T dA/dT
  X energy(X T) const {
    using std::sqrt;
    X const t = 1.0 / T;
    return 0.5 * c[1] * sqrt(T) + c[2] +
           t * (2.0 * c[3] + t * (3.0 * c[4] + t * (4.0 * c[5] + t * (5.0 * c[6]))));
  }
  /// -T d^2A/dT^2
  X heat_capacity(X T) const {
    using std::sqrt;
    X const t = 1.0 / T;
    return 0.25 * c[1] * t * sqrt(T) -
           t * t * (2.0 * c[3] + t * (6.0 * c[4] + t * (12.0 * c[5] + t * (20.0 * c[6]))));
  }
  /// d(-T d^2A/dT^2)/dT
  X heat_capacity_slope(X T) const {
    using std::sqrt;
    X const t = 1.0 / T;
    return t * t *
           (t * (4.0 * c[3] + t * (18.0 * c[4] + t * (48.0 * c[5] + t * (100.0 * c[6])))) -
            0.125 * c[1] * sqrt(T));
  }
};

/// The same series, continued below T_low with a constant heat capacity C(T) = C(T_low)
/// (fitting/README.md, Eq. (F9)):
///   e = e_low + C (T - T_low),  s = s_low + C ln(T/T_low),  A = e - T s.
/// The continuation is linear in the coefficients; hence the series of the pressure and of its density
/// derivative continue by the same formula, and all stay derivatives of one free energy.
/// A pack must not hold temperatures below T_low.
template <class X>
class ContinuedSeries {
 public:
  ContinuedSeries(TemperatureSeries<X> const& series, double T_low) : series_(series), T_low_(T_low) {}

  X value(X T) const { return above(T) ? series_.value(T) : energy(T) - T * entropy(T); }
  X entropy(X T) const { return above(T) ? series_.entropy(T) : cold_entropy(T); }
  X energy(X T) const { return above(T) ? series_.energy(T) : cold_energy(T); }
  X heat_capacity(X T) const { return series_.heat_capacity(above(T) ? T : X(T_low_)); }
  X heat_capacity_slope(X T) const { return above(T) ? series_.heat_capacity_slope(T) : X(0.0); }
  double T_low() const { return T_low_; }

 private:
  bool above(X T) const {
    if constexpr (std::is_same_v<X, Pack>)
      return true;
    else
      return real_part(T) >= T_low_;
  }
  X cold_entropy(X T) const {
    using std::log;
    X const low = T_low_;
    return series_.entropy(low) + series_.heat_capacity(low) * log(T / T_low_);
  }
  X cold_energy(X T) const {
    X const low = T_low_;
    return series_.energy(low) + series_.heat_capacity(low) * (T - T_low_);
  }

  TemperatureSeries<X> series_;
  double T_low_;
};

} // namespace mesobridge::fitting
