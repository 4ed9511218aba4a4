#include "sdpd/kernel/cubic.hpp"
#include "sdpd/kernel/lucy.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

template <class K>
class Kernel : public ::testing::Test {};
using Kernels = ::testing::Types<CubicKernel, LucyKernel>;
TYPED_TEST_SUITE(Kernel, Kernels);

TYPED_TEST(Kernel, HasIntegralOne) {
  double const h = 2.3;
  TypeParam const kernel(h);
  int const n = 200000;
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    double const r = (k + 0.5) * h / n;
    sum += 4 * std::numbers::pi * r * r * kernel.W(r) * h / n;
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

TYPED_TEST(Kernel, HasFAsMinusItsSlopeOverR) {
  double const h = 1.7;
  TypeParam const kernel(h);
  int checked = 0;
  for (double u = 0.005; u < 1; u += 0.01, ++checked) {
    double const r = u * h, d = 1e-6 * h;
    double const slope = (kernel.W(r + d) - kernel.W(r - d)) / (2 * d);
    EXPECT_NEAR(kernel.F(r, 1 / r) * r, -slope, 1e-7 * kernel.W(0.0) / h) << "r/h = " << u;
  }
  EXPECT_EQ(checked, 100);
}

TYPED_TEST(Kernel, IsFiniteAtZeroAndVanishesAtItsSupport) {
  TypeParam const kernel(2.5);
  EXPECT_TRUE(std::isfinite(kernel.F(1e-100, 1e100)));
  EXPECT_NEAR(kernel.W(2.5), 0, 1e-15);
  EXPECT_NEAR(kernel.F(2.5, 1 / 2.5), 0, 1e-15);
}

} // namespace
} // namespace mesobridge::sdpd
