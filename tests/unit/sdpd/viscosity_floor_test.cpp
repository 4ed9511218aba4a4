#include "sdpd/setup/viscosity_floor.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::sdpd {
namespace {

/// Friction, motion (S106), and what forces carry: 5 at least, at the friction 1.
double truth(double pairs) {
  return 3 + pairs + 1 / pairs;
}

std::vector<ViscosityTrial> trials_at(std::vector<double> const& pairs, double se,
                                      std::mt19937_64& generator) {
  std::normal_distribution<double> G;
  std::vector<ViscosityTrial> trials;
  for (double const x : pairs)
    trials.push_back({x, {truth(x) + se * G(generator), se, 40}});
  return trials;
}

TEST(ViscosityFloor, LiesBetweenTrialsWithTheErrorThatTheirsMake) {
  std::mt19937_64 generator(3);
  constexpr int draws = 1000;
  constexpr double se = 0.1;
  double z = 0, z2 = 0;
  int between = 0;
  for (int k = 0; k < draws; ++k) {
    auto const floor = viscosity_floor(trials_at({6, 2.4, 0.95, 0.38, 0.7, 1.4}, se, generator), 0);
    if (!floor.between)
      continue;
    ++between;
    EXPECT_LT(floor.realised.se, se);
    double const off = (floor.realised.mean - truth(1)) / floor.realised.se;
    z += off, z2 += off * off;
  }
  ASSERT_GT(between, 0.8 * draws);
  EXPECT_LT(std::abs(z / between), 0.5); // a hyperbola is a parabola only nearly
  EXPECT_NEAR(std::sqrt(z2 / between), 1, 0.25);
}

TEST(ViscosityFloor, IsWhatIsLeftWithoutFrictionWhereTrialsFallTowardsLess) {
  std::mt19937_64 generator(3);
  auto const falling = viscosity_floor(trials_at({30, 12, 4.8, 1.9}, 0.1, generator), 0.4);
  EXPECT_FALSE(falling.between);
  EXPECT_EQ(falling.pairs, 0.4);
  EXPECT_NEAR(falling.realised.se, std::hypot(0.1, 0.75), 1e-12);
  EXPECT_NEAR(falling.realised.mean, truth(1.9) - 1.5, 0.5);
  auto const bounded = viscosity_floor(trials_at({4.8, 1.9}, 0.1, generator), 1.9);
  EXPECT_DOUBLE_EQ(bounded.pairs, 1.9);
  EXPECT_NEAR(bounded.realised.se, 0.1, 1e-12);
  EXPECT_FALSE(viscosity_floor(trials_at({1, 0.5, 0.502}, 1e-6, generator), 0).between);
}

TEST(ViscosityFloor, IsJudgedByAllTrialsOfTheLeastFriction) {
  std::vector<ViscosityTrial> const trials{{1.9, {6, 0.5, 40}}, {1.9, {6, 0.05, 200}}};
  auto const floor = viscosity_floor(trials, 1.9);
  EXPECT_EQ(floor.pairs, 1.9);
  EXPECT_NEAR(floor.realised.mean, 6, 1e-9);
  EXPECT_LT(floor.realised.se, 0.051);
}

} // namespace
} // namespace mesobridge::sdpd
