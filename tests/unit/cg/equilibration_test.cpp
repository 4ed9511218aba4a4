#include "cg/equilibration.hpp"
#include "cg/estimate.hpp"
#include "md/error.hpp"
#include "unit/cg/ar1.hpp"
#include <gtest/gtest.h>

namespace mesobridge::cg::test {
namespace {

std::vector<double> decaying(std::size_t n, double amplitude, double time, std::mt19937_64& generator) {
  auto x = ar1(n, 0.8, 0.0, generator);
  for (std::size_t i = 0; i < n; ++i)
    x[i] += amplitude * std::exp(-double(i) / time);
  return x;
}

TEST(Equilibration, CutsADecayAndKeepsTheRest) {
  std::mt19937_64 generator(11);
  // 10 exp(-i/100) falls below the error of the mean, 0.04, at i = 550.
  int unbiased = 0, cases = 0;
  for (int k = 0; k < 50; ++k, ++cases) {
    auto const x = decaying(5000, 10.0, 100.0, generator);
    auto const found = detect_equilibration(x);
    EXPECT_GT(found.start, 150u);
    EXPECT_LT(found.start, 2500u);
    unbiased += agrees(estimate_mean(std::span(x).subspan(found.start)), 0.0, 3);
    auto const second = marginal_standard_error_start(x);
    EXPECT_GE(second, 100u);
    EXPECT_LE(second, 2500u);
    EXPECT_FALSE(agrees(estimate_mean(x), 0.0, 3) && estimate_mean(x).se < 0.06)
        << "uncut, the mean is wrong";
  }
  EXPECT_EQ(cases, 50);
  EXPECT_GE(unbiased, 47);
}

TEST(Equilibration, KeepsMostOfAStationarySeries) {
  std::mt19937_64 generator(12);
  double kept = 0;
  for (int k = 0; k < 100; ++k)
    kept += double(4000 - detect_equilibration(ar1(4000, 0.8, 5.0, generator)).start) / 4000 / 100;
  EXPECT_GT(kept, 0.8);
}

TEST(Equilibration, RefusesTooFewSamples) {
  std::vector<double> const x(39, 1.0);
  EXPECT_THROW(detect_equilibration(x), InputError);
  EXPECT_THROW(marginal_standard_error_start(x), InputError);
}

} // namespace
} // namespace mesobridge::cg::test
