#pragma once
#include "sdpd/kernel/smoothing_kernel.hpp"

namespace mesobridge::sdpd {

/// Lucy's kernel (sdpd/README.md, Eq. (S3)).
struct Lucy {
  static constexpr char const* name = "lucy";

  static KernelNorms norms(double h, double scale) {
    return {.W = scale * 105 / (16 * std::numbers::pi * h * h * h),
            .F = scale * 315 / (4 * std::numbers::pi * h * h * h * h * h)};
  }

  template <class X>
  static X W(double norm, X const& u) {
    return norm * (1.0 + 3.0 * u) * (1.0 - u) * (1.0 - u) * (1.0 - u);
  }

  template <class X>
  static X F(X const& norm, X const& u, X const& /*inverse_u*/) {
    return norm * (1.0 - u) * (1.0 - u);
  }
};

using LucyKernel = SmoothingKernel<Lucy>;

} // namespace mesobridge::sdpd
