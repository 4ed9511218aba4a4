#include "fitting/power_law.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::fitting {
namespace {

TEST(PowerLaw, FindsExponentAndPrefactorWithTheirErrors) {
  std::vector<double> const x{0.1, 0.15, 0.2, 0.3, 0.4};
  std::mt19937_64 generator(3);
  std::normal_distribution<double> G;
  int within = 0, runs = 200;
  for (int run = 0; run < runs; ++run) {
    std::vector<cg::Estimate> y;
    for (double const at : x) {
      double const exact = 9.5 * std::pow(at, 5.44);
      y.push_back({exact * (1 + 0.1 * G(generator)), 0.1 * exact, 8});
    }
    auto const law = fit_power_law(x, y);
    ASSERT_TRUE(law.known());
    within += std::abs(law.exponent.mean - 5.44) < 2 * law.exponent.se;
  }
  EXPECT_GT(within, 0.9 * runs);
}

TEST(PowerLaw, InvertsItselfAndLeavesOutWhatIsNotResolved) {
  std::vector<double> const x{0.1, 0.2, 0.4, 0.8};
  std::vector<cg::Estimate> y;
  for (double const at : x)
    y.push_back({2 * at * at * at, 1e-9, 8});
  y[0] = {-1, 10, 8};
  auto const law = fit_power_law(x, y);
  EXPECT_EQ(law.exponent.n_eff, 3);
  EXPECT_EQ(law.x_min, 0.2);
  EXPECT_NEAR(law.exponent.mean, 3, 1e-9);
  EXPECT_NEAR(law.x_of(2 * 0.3 * 0.3 * 0.3), 0.3, 1e-9);
  EXPECT_NEAR(law.logarithm_at(0.5).mean, std::log(0.25), 1e-9);
  y[1] = {0, 1, 8};
  EXPECT_FALSE(fit_power_law(x, y).known());
}

TEST(PowerLaw, KeepsBelowAValueAsOftenAsOneStandardErrorSays) {
  std::vector<double> const x{0.05, 0.08, 0.12, 0.2, 0.3};
  auto const exact = [](double at) { return 1e-3 * std::pow(at, 4); };
  std::mt19937_64 generator(7);
  std::normal_distribution<double> G;
  constexpr int draws = 200;
  for (double const wanted : {3e-9, 3e-7, 3e-6}) { // below, among and beyond what is fitted
    int kept = 0, by_mean = 0;
    for (int draw = 0; draw < draws; ++draw) {
      std::vector<cg::Estimate> y;
      for (double const at : x)
        y.push_back({exact(at) * std::exp(0.2 * G(generator)), 0.2 * exact(at), 8});
      auto const law = fit_power_law(x, y);
      ASSERT_TRUE(law.known());
      by_mean += exact(law.x_of(wanted)) <= wanted;
      kept += exact(law.x_surely_below(wanted)) <= wanted;
    }
    constexpr double expected = 0.8413, se = 0.026; // of a normal variable, and of the share of so many draws
    EXPECT_GT(kept, (expected - 2 * se) * draws) << wanted;
    EXPECT_LT(by_mean, (expected - 2 * se) * draws) << wanted;
    EXPECT_LT(kept, 0.99 * draws) << wanted;
  }
}

TEST(PowerLaw, KnowsNoValueBelowOfAnExponentWithinItsError) {
  PowerLaw law{.exponent = {1, 2, 3}, .log_prefactor = {0, 0.1, 3}};
  EXPECT_EQ(law.x_surely_below(1e-3), 0);
  law.exponent = {-4, 0.1, 3};
  EXPECT_EQ(law.x_surely_below(1e-3), 0);
  law.exponent = {4, 0.5, 3};
  double const x = law.x_surely_below(1e-3);
  EXPECT_LT(x, law.x_of(1e-3));
  EXPECT_NEAR(law.logarithm_at(x).mean + law.logarithm_at(x).se, std::log(1e-3), 1e-9);
}

} // namespace
} // namespace mesobridge::fitting
