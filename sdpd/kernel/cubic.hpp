#pragma once
#include "sdpd/simd/wide_lanes.hpp"
#include <numbers>

namespace mesobridge::sdpd {

/// The cubic spline with support h (sdpd/README.md, Eq. (S2)): W(r) and F(r) with grad W = -F r, for a number
/// or for lanes of numbers. Both are written without a branch, so that lanes cost no more. `scale` multiplies
/// both (see DensityCorrection).
class CubicKernel {
 public:
  static constexpr char const* name = "cubic";

  explicit CubicKernel(double h, double scale = 1)
      : h_(h), inv_h_(1 / h), W_norm_(scale * 8 / (std::numbers::pi * h * h * h)),
        F_norm_(scale * 48 / (std::numbers::pi * h * h * h * h * h)) {}

  /// Valid for 0 <= r <= h; units of 1/h^3.
  template <class X>
  X W(X const& r) const {
    X const u = r * inv_h_;
    X const outer = 2.0 * (1.0 - u) * (1.0 - u) * (1.0 - u);
    X const inner = 1.0 - 6.0 * u * u * (1.0 - u);
    return W_norm_ * (u < 0.5 ? inner : outer);
  }

  /// Valid for 0 <= r <= h, with 1/r; units of 1/h^5; also in single precision. Finite at r = 0.
  template <class X>
  X F(X const& r, X const& inverse_r) const {
    X const u = r * constant<X>(inv_h_);
    X const inner = 2.0 - 3.0 * u;
    X const outer = (1.0 - u) * (1.0 - u) * (inverse_r * constant<X>(h_));
    return constant<X>(F_norm_) * (u < constant<X>(0.5) ? inner : outer);
  }

 private:
  double h_, inv_h_, W_norm_, F_norm_;
};

} // namespace mesobridge::sdpd
