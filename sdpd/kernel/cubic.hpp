#pragma once
#include <numbers>

namespace mesobridge::sdpd {

/// The cubic spline with support h (theory sheet, section 2): W(r) and F(r) with grad W = -F r.
/// Both are written without a branch so that a loop over pairs vectorises.
class CubicKernel {
 public:
  static constexpr char const* name = "cubic";

  explicit CubicKernel(double h)
      : inv_h_(1 / h), W_norm_(8 / (std::numbers::pi * h * h * h)),
        F_norm_(48 / (std::numbers::pi * h * h * h * h * h)) {}

  /// Valid for 0 <= r <= h; units of 1/h^3.
  double W(double r) const {
    double const u = r * inv_h_;
    double const outer = 2 * (1 - u) * (1 - u) * (1 - u);
    double const inner = 1 - 6 * u * u * (1 - u);
    return W_norm_ * (u < 0.5 ? inner : outer);
  }

  /// Valid for 0 <= r <= h; units of 1/h^5. Finite at r = 0.
  double F(double r) const {
    double const u = r * inv_h_;
    double const inner = 2 - 3 * u;
    double const outer = (1 - u) * (1 - u) / (u < 0.5 ? 0.5 : u);
    return F_norm_ * (u < 0.5 ? inner : outer);
  }

 private:
  double inv_h_, W_norm_, F_norm_;
};

} // namespace mesobridge::sdpd
