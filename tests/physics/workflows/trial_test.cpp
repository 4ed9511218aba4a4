#include "cg/distribution_error.hpp"
#include "workflows/reproduce/ideal_gas_study.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/study/study.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

sdpd::TrialResult run(double dt, double time) {
  auto scene = small_sample(thesis_ideal_gas(5, "ems", 3), 216);
  auto const start = sdpd::equilibrated_start(settings_of(scene, 1), 0.05, 10, [] { return true; });
  set_times(scene, dt, 5, time);
  return sdpd::run_trial(engine_trial(scene, cg::bins_around(start.particles.eps, 5)), start,
                         [](std::uint64_t) { return true; });
}

// At K = 5 and dt = 0.4 Verlet's errors double the temperature within a few thousand units of time.
TEST(Trial, ThatRunsAwayKnowsTheDriftThatLedThere) {
  auto const away = run(0.4, 8000);
  ASSERT_TRUE(away.failed());
  EXPECT_NE(away.failure.find("kinetic temperature has grown"), std::string::npos) << away.failure;
  ASSERT_TRUE(away.knows_drift());
  EXPECT_GT(away.drift().rate, 3 * away.drift().se);
  // The whole way there is steeper than its beginning, since a hotter fluid drifts faster.
  double const mean = away.energies.back() / away.times.back();
  EXPECT_LT(away.drift().rate, 0.7 * mean);
  EXPECT_GT(away.drift().rate, 0.05 * mean);
}

TEST(Trial, ThatFailsAtOnceKnowsNothing) {
  auto const at_once = run(2, 100);
  EXPECT_TRUE(at_once.failed());
  EXPECT_FALSE(at_once.knows_drift());
}

TEST(Trial, ThatGoesThroughHasAllOfIt) {
  auto const fine = run(0.1, 30);
  EXPECT_FALSE(fine.failed()) << fine.failure;
  EXPECT_TRUE(fine.knows_drift());
  EXPECT_NEAR(fine.T_kin.mean, 1, 5 * fine.T_kin.se + 0.01);
}

} // namespace
} // namespace mesobridge::workflows
