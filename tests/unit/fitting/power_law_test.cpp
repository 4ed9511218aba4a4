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

} // namespace
} // namespace mesobridge::fitting
