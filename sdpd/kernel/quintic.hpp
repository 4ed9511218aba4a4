#pragma once
#include "sdpd/simd/wide_lanes.hpp"
#include <numbers>

namespace mesobridge::sdpd {

/// The quintic spline with support h (J. P. Morris, P. J. Fox and Y. Zhu, J. Comput. Phys. 136 (1997) 214):
/// W(r) = 9/(40 pi h^3) [(3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5], q = 3 r/h, powers of negative numbers being
/// zero, and F(r) with grad W = -F r; for a number or for lanes of numbers, without a branch. `scale`
/// multiplies both (see DensityCorrection).
class QuinticKernel {
 public:
  static constexpr char const* name = "quintic";

  explicit QuinticKernel(double h, double scale = 1)
      : per_q_(h / 3), q_per_r_(3 / h), W_norm_(scale * 9 / (40 * std::numbers::pi * h * h * h)),
        F_norm_(W_norm_ * 9 / (h * h)) {}

  /// Valid for 0 <= r <= h; units of 1/h^3.
  template <class X>
  X W(X const& r) const {
    X const q = r * q_per_r_;
    return W_norm_ *
           (power_5(3.0 - q) - 6.0 * power_5(positive(2.0 - q)) + 15.0 * power_5(positive(1.0 - q)));
  }

  /// Valid for 0 <= r <= h, with 1/r; units of 1/h^5; also in single precision. Finite at r = 0, where the
  /// polynomial of the innermost third takes the place of the powers, which cancel.
  template <class X>
  X F(X const& r, X const& inverse_r) const {
    X const q = r * constant<X>(q_per_r_), one = constant<X>(1);
    X const inner = constant<X>(120) - q * q * (constant<X>(120) - constant<X>(50) * q);
    X const outer = constant<X>(5) *
                    (power_4(constant<X>(3) - q) - constant<X>(6) * power_4(positive(constant<X>(2) - q))) *
                    (inverse_r * constant<X>(per_q_));
    return constant<X>(F_norm_) * (q < one ? inner : outer);
  }

 private:
  template <class X>
  static X positive(X const& x) {
    X const zero{};
    return x < zero ? zero : x;
  }
  template <class X>
  static X power_4(X const& x) {
    X const square = x * x;
    return square * square;
  }
  template <class X>
  static X power_5(X const& x) {
    return power_4(x) * x;
  }

  double per_q_, q_per_r_, W_norm_, F_norm_;
};

} // namespace mesobridge::sdpd
