#pragma once
#include "sdpd/kernel/smoothing_kernel.hpp"

namespace mesobridge::sdpd {

/// The quintic spline (J. P. Morris, P. J. Fox and Y. Zhu, J. Comput. Phys. 136 (1997) 214):
/// W(r) = 9/(40 pi h^3) [(3 - u)^5 - 6 (2 - u)^5 + 15 (1 - u)^5], u = 3 r/h, powers of negative numbers being
/// zero.
struct QuinticSpline {
  static constexpr char const* name = "quintic";

  static KernelNorms norms(double h, double scale) {
    double const W = scale * 9 / (40 * std::numbers::pi * h * h * h);
    return {.W = W, .F = W * 9 / (h * h)};
  }

  template <class X>
  static X W(double norm, X const& u) {
    return norm * (power_5(3.0 - u) - 6.0 * power_5(positive(2.0 - u)) + 15.0 * power_5(positive(1.0 - u)));
  }

  /// In the innermost third a polynomial takes the place of the powers, which cancel at r = 0.
  template <class X>
  static X F(X const& norm, X const& u, X const& inverse_u) {
    X const one = constant<X>(1);
    X const inner = constant<X>(120) - u * u * (constant<X>(120) - constant<X>(50) * u);
    X const outer = constant<X>(5) *
                    (power_4(constant<X>(3) - u) - constant<X>(6) * power_4(positive(constant<X>(2) - u))) *
                    inverse_u;
    return norm * (u < one ? inner : outer);
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
};

using QuinticKernel = SmoothingKernel<QuinticSpline, 3>;

} // namespace mesobridge::sdpd
