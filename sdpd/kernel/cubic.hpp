#pragma once
#include "sdpd/kernel/smoothing_kernel.hpp"

namespace mesobridge::sdpd {

/// The cubic spline (sdpd/README.md, Eq. (S2)).
struct CubicSpline {
  static constexpr char const* name = "cubic";

  static KernelNorms norms(double h, double scale) {
    return {.W = scale * 8 / (std::numbers::pi * h * h * h),
            .F = scale * 48 / (std::numbers::pi * h * h * h * h * h)};
  }

  template <class X>
  static X W(double norm, X const& u) {
    X const outer = 2.0 * (1.0 - u) * (1.0 - u) * (1.0 - u);
    X const inner = 1.0 - 6.0 * u * u * (1.0 - u);
    return norm * (u < 0.5 ? inner : outer);
  }

  template <class X>
  static X F(X const& norm, X const& u, X const& inverse_u) {
    X const inner = 2.0 - 3.0 * u;
    X const outer = (1.0 - u) * (1.0 - u) * inverse_u;
    return norm * (u < constant<X>(0.5) ? inner : outer);
  }
};

using CubicKernel = SmoothingKernel<CubicSpline>;

} // namespace mesobridge::sdpd
