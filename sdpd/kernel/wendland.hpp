#pragma once
#include "sdpd/kernel/smoothing_kernel.hpp"

namespace mesobridge::sdpd {

/// What Wendland's kernels in three dimensions share (Dehnen and Aly, MNRAS 425 (2012) 1068; sdpd/README.md,
/// Eq. (S4)): W(0) = over/(under pi h^3), F(0) = slope W(0)/h^2. They have no pairing instability.
template <int over, int under, double slope>
struct Wendland {
  static KernelNorms norms(double h, double scale) {
    double const W = double{over} / (under * std::numbers::pi * h * h * h) * scale;
    return {.W = W, .F = slope * W / (h * h)};
  }
};

struct WendlandC2 : Wendland<21, 2, 20.0> {
  static constexpr char const* name = "wendland-c2";

  template <class X>
  static X W(double norm, X const& u) {
    X const v = 1.0 - u, v2 = v * v;
    return norm * v2 * v2 * (1.0 + 4.0 * u);
  }

  template <class X>
  static X F(X const& norm, X const& u, X const& /*inverse_u*/) {
    X const v = 1.0 - u, v2 = v * v;
    return norm * v2 * v;
  }
};

struct WendlandC4 : Wendland<495, 32, 56.0 / 3> {
  static constexpr char const* name = "wendland-c4";

  template <class X>
  static X W(double norm, X const& u) {
    X const v = 1.0 - u, v2 = v * v, v4 = v2 * v2;
    return norm * v4 * v2 * (1.0 + u * (6.0 + 35.0 / 3 * u));
  }

  template <class X>
  static X F(X const& norm, X const& u, X const& /*inverse_u*/) {
    X const v = 1.0 - u, v2 = v * v, v4 = v2 * v2;
    return norm * v4 * v * (1.0 + 5.0 * u);
  }
};

struct WendlandC6 : Wendland<1365, 64, 22.0> {
  static constexpr char const* name = "wendland-c6";

  template <class X>
  static X W(double norm, X const& u) {
    X const v = 1.0 - u, v2 = v * v, v4 = v2 * v2;
    return norm * v4 * v4 * (1.0 + u * (8.0 + u * (25.0 + 32.0 * u)));
  }

  template <class X>
  static X F(X const& norm, X const& u, X const& /*inverse_u*/) {
    X const v = 1.0 - u, v2 = v * v, v4 = v2 * v2;
    return norm * v4 * v2 * v * (1.0 + u * (7.0 + 16.0 * u));
  }
};

using WendlandC2Kernel = SmoothingKernel<WendlandC2>;
using WendlandC4Kernel = SmoothingKernel<WendlandC4>;
using WendlandC6Kernel = SmoothingKernel<WendlandC6>;

} // namespace mesobridge::sdpd
