#pragma once
#include "sdpd/simd/wide_lanes.hpp"
#include <numbers>

namespace mesobridge::sdpd {

/// Wendland's C4 kernel in three dimensions with support h (Dehnen and Aly, MNRAS 425 (2012) 1068): W(r) and
/// F(r) with grad W = -F r, for a number or for lanes of numbers. It has no pairing instability. `scale`
/// multiplies both (see DensityCorrection).
class WendlandC4Kernel {
 public:
  static constexpr char const* name = "wendland-c4";

  explicit WendlandC4Kernel(double h, double scale = 1)
      : inv_h_(1 / h), W_norm_(495.0 / (32 * std::numbers::pi * h * h * h) * scale),
        F_norm_(56.0 / 3 * W_norm_ / (h * h)) {}

  /// Valid for 0 <= r <= h; units of 1/h^3.
  template <class X>
  X W(X const& r) const {
    X const u = r * inv_h_, v = 1.0 - u, v2 = v * v, v4 = v2 * v2;
    return W_norm_ * v4 * v2 * (1.0 + u * (6.0 + 35.0 / 3 * u));
  }

  /// Valid for 0 <= r <= h, with 1/r; units of 1/h^5; also in single precision.
  template <class X>
  X F(X const& r, X const& /*inverse_r*/) const {
    X const u = r * constant<X>(inv_h_), v = 1.0 - u, v2 = v * v, v4 = v2 * v2;
    return constant<X>(F_norm_) * v4 * v * (1.0 + 5.0 * u);
  }

 private:
  double inv_h_, W_norm_, F_norm_;
};

} // namespace mesobridge::sdpd
