#include "workflows/study/power_law.hpp"
#include "workflows/study/trade_off.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::workflows {
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

TrialResult trial(double dt, double drift, double us, double T_kin) {
  TrialResult result;
  result.dt = dt;
  result.drift_of_mean = {drift, 1e-12};
  result.us_per_particle_step = us;
  result.T_kin = {T_kin, 1e-4, 100}, result.T_int = {1, 1e-4, 100}, result.P = {1, 1e-4, 100};
  return result;
}

/// Two schemes with drifts 1e-3 dt^4 and 1e-5 dt^4, the second one half as dear again.
TradeOff two_schemes() {
  TradeOff found{.scene = {}, .plan = {.dt = {0.1, 0.2, 0.4}, .K = {10}}, .configurations = {}};
  for (double const prefactor : {1e-3, 1e-5}) {
    Configuration of{.scheme = prefactor > 1e-4 ? "ssa" : "ems",
                     .splitting = "lie-trotter",
                     .integrator = "verlet",
                     .K = 10};
    std::vector<cg::Estimate> rates;
    for (double const dt : found.plan.dt) {
      double const rate = prefactor * dt * dt * dt * dt;
      of.trials.push_back(trial(dt, rate, prefactor > 1e-4 ? 1 : 1.5, 1 + 0.1 * dt * dt));
      rates.push_back({rate, 1e-12, 8});
    }
    of.drift = fit_power_law(found.plan.dt, rates);
    found.configurations.push_back(of);
  }
  return found;
}

TEST(TradeOff, RecommendsTheCheapestSchemeThatMeetsTheTarget) {
  auto const found = two_schemes();
  auto const strict = recommend(found, 10, {.drift = 1e-7}); // dt = 0.1 at cost 1 against 0.316 at 1.5
  ASSERT_TRUE(strict);
  EXPECT_EQ(strict->configuration, 1u);
  EXPECT_NEAR(strict->dt, 0.31, 1e-12); // rounded down
  EXPECT_NEAR(strict->us_per_particle_time, 1.5 / 0.31, 1e-9);
  auto const loose = recommend(found, 10, {.drift = 1e-3}); // both at the largest time step that was run
  ASSERT_TRUE(loose);
  EXPECT_EQ(loose->configuration, 0u);
  EXPECT_EQ(loose->dt, 0.4);
  EXPECT_NE(loose->because.find("largest time step"), std::string::npos);
  EXPECT_FALSE(recommend(found, 10, {.drift = 1e-14})); // far below the time steps that were run
  EXPECT_FALSE(recommend(found, 50, {.drift = 1e-3}));  // no such size
}

TEST(TradeOff, LimitsTheTimeStepByBiasAndByStability) {
  auto found = two_schemes();
  auto const biased = largest_dt(found, 1, {.bias = 1e-3}); // T_kin = 1 + 0.1 dt^2
  ASSERT_TRUE(biased);
  EXPECT_NEAR(biased->dt, 0.1, 0.01);
  EXPECT_NE(biased->because.find("bias"), std::string::npos);
  found.configurations[1].failing_dt = 0.25;
  auto const stable = largest_dt(found, 1, {.drift = 1e-3});
  ASSERT_TRUE(stable);
  EXPECT_NEAR(stable->dt, 0.2, 1e-12);
  EXPECT_EQ(stable->because, "stability");
  for (auto& failed : found.configurations[1].trials)
    failed.failure = "it did";
  EXPECT_FALSE(largest_dt(found, 1, {.drift = 1e-3}));
}

TEST(Trial, JudgesByTheBetterKnownDriftUnlessTheyDisagree) {
  TrialResult result;
  result.drift_of_mean = {1e-6, 5e-7}, result.drift_of_walk = {8e-7, 1e-7};
  EXPECT_EQ(result.drift().rate, 8e-7);
  result.drift_of_mean = {1e-5, 5e-7};
  EXPECT_EQ(result.drift().rate, 1e-5);
  result.drift_of_walk = {};
  EXPECT_EQ(result.drift().rate, 1e-5);
}

TEST(Distribution, HasTheGammaLawAndItsDistance) {
  EnergyBins const bins{.lower = 0, .upper = 40, .count = 400};
  auto const law = gamma_law(5, bins);
  double sum = 0, mean = 0;
  for (std::size_t b = 0; b < bins.count; ++b) {
    sum += law[b] * bins.width();
    mean += law[b] * bins.width() * (static_cast<double>(b) + 0.5) * bins.width();
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_NEAR(mean, 6, 1e-3); // C_K = (3/2)(K - 1)
  EXPECT_EQ(distribution_error(law, law), 0);
  EXPECT_NEAR(distribution_error(std::vector<double>(bins.count, 0.0), law), 1, 1e-12);
}

} // namespace
} // namespace mesobridge::workflows
