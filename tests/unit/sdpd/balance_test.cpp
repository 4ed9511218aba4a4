#include "md/error.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/setup/balance.hpp"
#include "sdpd/setup/trial.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

TEST(EnergyBalance, IsTheErrorOverWhatIsTurnedOver) {
  BalanceSeries series{.times = {1, 2}, .errors = {0.1, -0.3}, .given = {2, 6}, .exchanged = {-1, 3}};
  EXPECT_DOUBLE_EQ(error_share(series), 0.05);
  series.exchanged = {-12, 3};
  EXPECT_DOUBLE_EQ(error_share(series), 0.025);
  EXPECT_EQ(error_share({}), 0);
}

/// Errors that grow linearly and quadratically are continued so; what comes from outside grows linearly.
TEST(EnergyBalance, GoesOnAsItBegan) {
  BalanceSeries linear, quadratic;
  for (int k = 1; k <= 20; ++k) {
    double const t = 0.1 * k;
    linear.times.push_back(t), linear.errors.push_back(-0.01 * t), linear.given.push_back(t);
    quadratic.times.push_back(t), quadratic.errors.push_back(0.01 * t * t), quadratic.given.push_back(t);
  }
  EXPECT_NEAR(error_share_at(linear, 2), 0.01, 1e-12);
  EXPECT_NEAR(error_share_at(linear, 10), 0.01, 1e-12);
  EXPECT_NEAR(error_share_at(quadratic, 2), 0.02, 1e-12);
  EXPECT_NEAR(error_share_at(quadratic, 10), 0.1, 1e-12);
  // Never less than a linear one: an error that has come to a stand may go on.
  BalanceSeries still = linear;
  for (std::size_t k = 0; k < still.errors.size(); ++k)
    still.errors[k] = 0.02;
  EXPECT_GE(error_share_at(still, 10), 0.02 * 5 / (2 * 5) - 1e-12);
}

/// Viscous and without noise, so that the error is that of the time step alone.
SimulationSettings piston(double dt) {
  auto settings = argon(100, dt);
  settings.noise = false;
  settings.as<Sdpd>().kernel = "wendland-c4";
  settings.lattice = {7, 7, 24};
  settings.disorder = 0.05;
  settings.faces[2][0] = {.kind = FaceKind::wall, .motion = {1000, 0}};
  settings.faces[2][1].kind = FaceKind::wall;
  return settings;
}

TEST(EnergyBalance, OfATrialFallsWithTheTimeStep) {
  auto const start = equilibrated_start(piston(0.02), 0.02, 0, [] { return true; });
  auto const run = [&](double dt) {
    return run_balance_trial(
        {.settings = piston(dt), .steps = std::int64_t(2 / dt), .run_steps = std::int64_t(2 / dt)}, start,
        [](std::int64_t) { return true; });
  };
  auto const coarse = run(0.04), fine = run(0.01);
  ASSERT_FALSE(coarse.failed() || fine.failed());
  EXPECT_GT(fine.share, 0);
  EXPECT_LT(fine.share, coarse.share / 3);   // by a quarter of the step
  EXPECT_EQ(coarse.share, coarse.run_share); // there is nothing beyond
}

TEST(EnergyBalance, OfATrialThatFailsSaysWhy) {
  auto const start = equilibrated_start(piston(0.02), 0.02, 0.2, [] { return true; });
  auto const found = run_balance_trial({.settings = piston(1), .steps = 50, .run_steps = 50}, start,
                                       [](std::int64_t) { return true; });
  EXPECT_TRUE(found.failed());
  EXPECT_THROW(run_balance_trial({.settings = piston(0.02), .steps = 50, .run_steps = 50}, start,
                                 [](std::int64_t) { return false; }),
               Interrupted);
}

} // namespace
} // namespace mesobridge::sdpd
