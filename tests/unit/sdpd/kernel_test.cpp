#include "md/error.hpp"
#include "sdpd/kernel/list.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

template <class K>
class Kernel : public ::testing::Test {};
template <class V>
struct TypesOf;
template <class... K>
struct TypesOf<std::variant<K...>> {
  using type = ::testing::Types<K...>;
};
using Kernels = TypesOf<AnyKernel>::type;
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

TYPED_TEST(Kernel, HasFInSinglePrecisionToo) {
  TypeParam const kernel(1.7);
  int checked = 0;
  for (float r = 0.01f; r < 1.7f; r += 0.003f, ++checked) {
    float const F = kernel.F(r - WideFloats{}, 1 / r - WideFloats{})[9];
    EXPECT_NEAR(F, kernel.F(double{r}, 1 / double{r}), 1e-6 * kernel.F(0.1, 10.0)) << "r = " << r;
  }
  EXPECT_GT(checked, 500);
}

TYPED_TEST(Kernel, IsFiniteAtZeroAndVanishesAtItsSupport) {
  TypeParam const kernel(2.5);
  EXPECT_TRUE(std::isfinite(kernel.F(1e-100, 1e100)));
  EXPECT_NEAR(kernel.W(2.5), 0, 1e-15);
  EXPECT_NEAR(kernel.F(2.5, 1 / 2.5), 0, 1e-15);
}

TYPED_TEST(Kernel, IsScaledAsAWhole) {
  TypeParam const plain(1.9), scaled(1.9, 1.25);
  EXPECT_NEAR(scaled.W(0.7) / plain.W(0.7), 1.25, 1e-14);
  EXPECT_NEAR(scaled.F(0.7, 1 / 0.7) / plain.F(0.7, 1 / 0.7), 1.25, 1e-14);
}

TEST(KernelList, FindsEveryKernelByItsNameAndRefusesOthers) {
  auto const names = kernel_names();
  EXPECT_EQ(names.size(), std::variant_size_v<AnyKernel>);
  for (auto const& name : names)
    EXPECT_EQ(std::visit([](auto const& kernel) { return std::string(kernel.name); }, make_kernel(name, 2.5)),
              name);
  EXPECT_THROW(make_kernel("gaussian", 2.5), InputError);
}

TEST(GlassCorrection, IsThatOfDehnenAndAly) {
  EXPECT_NEAR(glass_correction("wendland-c2", 100).self, 0.0294, 1e-15);
  EXPECT_NEAR(glass_correction("wendland-c6", 400).self, 0.0116 * std::pow(4, -2.236), 1e-15);
  EXPECT_THROW(glass_correction("cubic", 100), InputError); // it clumps
  EXPECT_THROW(glass_correction("wendland-c2", 20), InputError);
  EXPECT_THROW(glass_correction("gaussian", 60), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
