#pragma once
#include "sdpd/simd/wide_lanes.hpp"
#include <numbers>

namespace mesobridge::sdpd {

/// The constant factors of W [1/h^3] and F [1/h^5].
struct KernelNorms {
  double W, F;
};

/// A smoothing kernel with support h: W(r) and F(r) with grad W = -F r, for a number or for lanes of numbers.
/// Its formulas are those of `Shape`, in u = pieces r/h: `name`, norms(h, scale), W(norm, u) and
/// F(norm, u, 1/u), without a branch, so that lanes cost no more. `scale` multiplies W and F (see
/// DensityCorrection).
template <class Shape, int pieces = 1>
class SmoothingKernel {
 public:
  static constexpr char const* name = Shape::name;

  explicit SmoothingKernel(double h, double scale = 1)
      : unit_(h / pieces), inv_unit_(pieces / h), norms_(Shape::norms(h, scale)) {}

  /// Valid for 0 <= r <= h; units of 1/h^3.
  template <class X>
  X W(X const& r) const {
    return Shape::template W<X>(norms_.W, r * inv_unit_);
  }

  /// Valid for 0 <= r <= h, with 1/r; units of 1/h^5; also in single precision. Finite at r = 0.
  template <class X>
  X F(X const& r, X const& inverse_r) const {
    return Shape::template F<X>(constant<X>(norms_.F), r * constant<X>(inv_unit_),
                                inverse_r * constant<X>(unit_));
  }

 private:
  double unit_, inv_unit_; // r at u = 1, and one over it
  KernelNorms norms_;
};

} // namespace mesobridge::sdpd
