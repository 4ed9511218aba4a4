#pragma once
#include "sdpd/simd/wide_lanes.hpp"
#include <numbers>

namespace mesobridge::sdpd {

/// Lucy's kernel with support h (sdpd/README.md, Eq. (S3)): W(r) and F(r) with grad W = -F r, for a number or
/// for lanes of numbers. `scale` multiplies both (see DensityCorrection).
class LucyKernel {
 public:
  static constexpr char const* name = "lucy";

  explicit LucyKernel(double h, double scale = 1)
      : inv_h_(1 / h), W_norm_(scale * 105 / (16 * std::numbers::pi * h * h * h)),
        F_norm_(scale * 315 / (4 * std::numbers::pi * h * h * h * h * h)) {}

  /// Valid for 0 <= r <= h; units of 1/h^3.
  template <class X>
  X W(X const& r) const {
    X const u = r * inv_h_;
    return W_norm_ * (1.0 + 3.0 * u) * (1.0 - u) * (1.0 - u) * (1.0 - u);
  }

  /// Valid for 0 <= r <= h, with 1/r; units of 1/h^5; also in single precision.
  template <class X>
  X F(X const& r, X const& /*inverse_r*/) const {
    X const u = r * constant<X>(inv_h_);
    return constant<X>(F_norm_) * (1.0 - u) * (1.0 - u);
  }

 private:
  double inv_h_, W_norm_, F_norm_;
};

} // namespace mesobridge::sdpd
