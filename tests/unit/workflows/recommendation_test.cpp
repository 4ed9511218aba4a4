#include "sdpd/method/step_diffusion.hpp"
#include "sdpd_scene.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/study/rounded_dt.hpp"
#include "workflows/study/trade_off.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

sdpd::TrialResult trial(double dt, double drift, double us, double T_kin) {
  sdpd::TrialResult result;
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
    of.drift = fitting::fit_power_law(found.plan.dt, rates);
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

TEST(TradeOff, TakesWhatRatesCanBeAtMostWhereTheirExponentIsNotResolved) {
  auto found = two_schemes();
  auto& of = found.configurations[0];
  of.drift.exponent = {0.15, 0.45, 3};
  auto const dt = largest_dt(found, 0, {.drift = 1e-4}); // 1e-3 dt^4 is 2.56e-5 at the largest
  ASSERT_TRUE(dt);
  EXPECT_EQ(dt->dt, 0.4);
  EXPECT_FALSE(largest_dt(found, 0, {.drift = 1e-9}));
}

TEST(TradeOff, LimitsTheTimeStepByHeatingWithoutSizesAndRefusesWhatLiesFarBelow) {
  auto found = two_schemes();
  found.scene.run.steps = 1'000'000;
  auto& of = found.configurations[0];
  of.K = 0; // as of DPDE, whose k_B is 1
  for (auto& one : of.trials)
    one.heat_capacity = 1.5, one.E_0 = 3;
  auto const heated = largest_dt(found, 0, {.bias = 0.01});
  ASSERT_TRUE(heated);
  EXPECT_EQ(heated->because, "the wanted bias over the run's length");
  EXPECT_NEAR(heated->dt, std::pow(5e-6, 0.2), 0.01);
  found.scene.run.steps = 1'000'000'000'000; // dt^5 = 5e-12 is 20 times shorter than all that were run
  EXPECT_FALSE(largest_dt(found, 0, {.bias = 0.01}));
}

TEST(TradeOff, LimitsTheTimeStepByTheHeatingOfAWholeRun) {
  auto found = two_schemes();
  found.scene.run.steps = 1'000'000;
  for (auto& one : found.configurations[0].trials)
    one.heat_capacity = 1.5 * 10, one.E_0 = 3; // dE/dT = 1.5 in units of k_B = 1/K
  // 1e-3 dt^4 of E_0 in each unit of time warms the fluid by 2e-3 dt^4 (10^6 dt): by 1 % at dt^5 = 5e-6.
  auto const heated = largest_dt(found, 0, {.bias = 0.01});
  ASSERT_TRUE(heated);
  EXPECT_EQ(heated->because, "the wanted bias over the run's length");
  EXPECT_NEAR(heated->dt, std::pow(5e-6, 0.2), 0.01);
  EXPECT_LE(heated->dt, std::pow(5e-6, 0.2));
  found.configurations[0].drift.exponent.se = 6; // says nothing
  auto const unknown = largest_dt(found, 0, {.bias = 0.01});
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->because, "the wanted bias");
}

// A fluid that is warmer by 6 % diffuses faster by as much.
TEST(TradeOff, LimitsTheTimeStepForTheDynamicsByHeatingToo) {
  auto found = two_schemes();
  found.scene = parse_scene(tests::SdpdScene{}.text(), "s.toml");
  auto& of = found.configurations[0];
  for (auto& one : of.trials)
    one.heat_capacity = 1.5 * 10, one.E_0 = 3, one.D = {3, 1e-3, 100}; // whatever the step
  found.scene.run.steps = 1;
  auto const cold = largest_dt(found, 0, {.dynamics = 0.06});
  ASSERT_TRUE(cold);
  EXPECT_GT(cold->dt, 0.2);
  found.scene.run.steps = 1'000'000; // 2e-3 dt^4 (10^6 dt) of T: 6 % at dt^5 = 3e-5
  auto const heated = largest_dt(found, 0, {.dynamics = 0.06});
  ASSERT_TRUE(heated);
  EXPECT_EQ(heated->because, "the wanted dynamics over the run's length");
  EXPECT_NEAR(heated->dt, std::pow(3e-5, 0.2), 0.01);
  EXPECT_LE(heated->dt, std::pow(3e-5, 0.2));
}

TEST(TradeOff, LimitsTheTimeStepByWhatTrialsShowOfTheDiffusion) {
  auto found = two_schemes();
  found.scene = parse_scene(tests::SdpdScene{}.text(), "s.toml");
  Scene sized = found.scene;
  sized.particles.K = 10;
  double const rate = sdpd::velocity_decay_rate(settings_of(sized, 1));
  auto const unmeasured = largest_dt(found, 0, {.dynamics = 0.05});
  ASSERT_TRUE(unmeasured); // the bound of a particle alone
  EXPECT_EQ(unmeasured->dt, rounded_down(sdpd::step_of_diffusion_excess(rate, 0.05)));
  EXPECT_EQ(unmeasured->because, "the wanted dynamics");
  for (auto& trial : found.configurations[0].trials) {
    double const D = 3 * (1 + 0.2 * sdpd::diffusion_excess(rate, trial.dt));
    trial.D = {D, 1e-6 * D, 100};
  }
  auto const measured = largest_dt(found, 0, {.dynamics = 0.05});
  ASSERT_TRUE(measured);
  EXPECT_NEAR(sdpd::diffusion_excess(rate, measured->dt), 0.25, 0.05); // 0.05/0.2, rounded down
  EXPECT_LE(sdpd::diffusion_excess(rate, measured->dt), 0.25);
}

} // namespace
} // namespace mesobridge::workflows
