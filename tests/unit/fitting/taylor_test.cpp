#include "fitting/eos/taylor.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

TEST(Taylor, ElementaryFunctionsHaveTheirSeries) {
  double const x = 1.7;
  auto const at = Taylor<double, 3>::variable(x);
  auto expect = [](Taylor<double, 3> const& f, std::array<double, 4> const& derivatives) {
    double factorial = 1;
    for (int k = 0; k < 4; ++k) {
      factorial *= std::max(k, 1);
      EXPECT_NEAR(f.c[k] * factorial, derivatives[k], 1e-14 * (1 + std::abs(derivatives[k])));
    }
  };
  double const e = std::exp(x), r = std::sqrt(x);
  expect(exp(at), {e, e, e, e});
  expect(log(at), {std::log(x), 1 / x, -1 / (x * x), 2 / (x * x * x)});
  expect(sqrt(at), {r, 0.5 / r, -0.25 / (r * x), 0.375 / (r * x * x)});
  expect(1.0 / at, {1 / x, -1 / (x * x), 2 / std::pow(x, 3), -6 / std::pow(x, 4)});
  expect(2.0 - at * at * at / 4.0, {2 - x * x * x / 4, -0.75 * x * x, -1.5 * x, -1.5});
}

TEST(Taylor, InverseFunctionsCancel) {
  auto const x = Taylor<double, 3>::variable(0.8);
  auto const y = log(exp(x)) - x, z = sqrt(x * x) - x, w = (x * x + 1.0) / (x * x + 1.0) - 1.0;
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(std::abs(y.c[k]) + std::abs(z.c[k]) + std::abs(w.c[k]), 0, 1e-14);
}

TEST(Taylor, NestedSeriesGiveMixedDerivatives) {
  using Mixed = Taylor<Taylor<double, 1>, 1>;
  double const x = 0.6, y = 1.3;
  Mixed const u = Mixed::variable(Taylor<double, 1>(x)), v(Taylor<double, 1>::variable(y));
  auto const f = exp(u * v) * log(v) / u;
  // d/dx d/dy [exp(x y) ln y / x]
  double const E = std::exp(x * y);
  EXPECT_NEAR(f.c[1].c[1], E * (y * std::log(y) + (y - 1 / x) / (x * y)), 1e-13);
}

} // namespace
} // namespace mesobridge::fitting::test
