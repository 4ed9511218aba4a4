#include "sdpd/observe/detonation_front.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::sdpd {
namespace {

constexpr double D = 7, u = 3, length = 6; // of the wave, the flow behind it and the reaction

/// Runs at D from z = 0, reacts as 1 - exp(-x/length) and has noise in all slices.
struct Wave {
  double noise = 0.1, acceleration = 0;
  int slices = 400;
  bool comes_back = false; ///< from the far end, behind it the flow at rest

  ShockScale scale() const {
    ShockScale of{.position = {}, .v_P = u, .spacing = 1};
    for (int s = 0; s < slices; ++s)
      of.position.push_back(s + 0.5);
    return of;
  }
  std::vector<DetonationFrame> frames(int count) const {
    std::mt19937 generator(3);
    std::normal_distribution<double> G(0, noise);
    std::vector<DetonationFrame> all;
    for (int k = 0; k < count; ++k) {
      double const time = 0.5 * k, way = D * time + 0.5 * acceleration * time * time;
      bool const back = comes_back && way > slices;
      double const front = back ? 2 * slices - way : way;
      DetonationFrame frame{{.time = time, .piston = 0, .velocity = {}, .rho = {}, .P = {}, .T = {}}, {}};
      for (double const z : scale().position) {
        double const shocked = 0.5 * (1 - std::tanh(2 * (z - front)));
        double const x = back ? slices : std::max(front - z, 0.0);
        frame.flow.velocity.push_back(u * shocked + G(generator));
        frame.flow.rho.push_back(1 + shocked + G(generator));
        frame.flow.P.push_back(20 * shocked + G(generator));
        frame.flow.T.push_back(1 + 9 * shocked + G(generator));
        frame.progress.push_back(1 - std::exp(-x / length));
      }
      all.push_back(std::move(frame));
    }
    return all;
  }
};

TEST(DetonationFront, HasItsVelocityAndTheLengthOfItsZone) {
  Wave const wave;
  auto const found = steady_detonation(wave.frames(110), wave.scale(), 0.3);
  ASSERT_TRUE(found);
  EXPECT_GT(found->times.size(), 40u);
  EXPECT_GE(found->fronts.front(), 0.3 * 399.5);
  double const zone = length * std::log(0.98 / 0.02);
  EXPECT_LT(found->D.se, 0.01 * D);
  EXPECT_LT(std::abs(cg::deviation(found->D, D)), 6);
  EXPECT_GT(std::abs(cg::deviation(found->D, 1.05 * D)), 6);
  EXPECT_NEAR(found->zone.mean, zone, 0.02 * zone);
  EXPECT_LT(std::abs(cg::deviation(found->change_of_D, 0)), 4);
  // the profile in the front's frame is the wave
  std::size_t compared = 0;
  for (std::size_t k = 0; k < found->profile.depth.size(); ++k)
    if (double const depth = found->profile.depth[k]; depth < -3 && depth > -60) {
      EXPECT_NEAR(found->profile.progress[k].mean, 1 - std::exp(depth / length), 0.02);
      EXPECT_NEAR(found->profile.P[k].mean, 20, 0.2);
      ++compared;
    }
  EXPECT_GT(compared, 50u);
}

TEST(DetonationFront, SaysThatAWaveStillChanges) {
  Wave wave;
  wave.acceleration = 0.03, wave.noise = 0.02;
  auto const found = steady_detonation(wave.frames(100), wave.scale(), 0.3);
  ASSERT_TRUE(found);
  // halves of the frames are half of their time apart
  double const apart = (found->times.back() - found->times.front()) / 2;
  EXPECT_NEAR(found->change_of_D.mean, wave.acceleration * apart, 0.15 * wave.acceleration * apart);
}

// A frame that nobody finds a front in is no place to look for the next one's.
TEST(DetonationFront, KnowsWhichFramesItTook) {
  Wave const wave;
  auto frames = wave.frames(110);
  frames[70].flow.velocity.assign(frames[70].flow.velocity.size(), 0);
  auto const found = steady_detonation(frames, wave.scale(), 0.3);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->frames.size(), found->times.size());
  for (std::size_t k = 0; k < found->frames.size(); ++k)
    EXPECT_EQ(frames[found->frames[k]].flow.time, found->times[k]);
  EXPECT_EQ(found->frames.back() - found->frames.front(), found->frames.size());
}

// Behind a piston there is no fluid: its zeros are no part of any mean.
TEST(DetonationFront, LeavesOutSlicesThatAPistonHasLeft) {
  Wave const wave;
  auto frames = wave.frames(110);
  for (auto& frame : frames)
    for (std::size_t s = 0; static_cast<double>(s) < 0.8 * D * frame.flow.time; ++s)
      for (auto* values :
           {&frame.flow.velocity, &frame.flow.rho, &frame.flow.P, &frame.flow.T, &frame.progress})
        (*values)[s] = 0;
  auto const found = steady_detonation(frames, wave.scale(), 0.3);
  ASSERT_TRUE(found);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < found->profile.depth.size(); ++k)
    if (found->profile.depth[k] < -20) {
      EXPECT_NEAR(found->profile.P[k].mean, 20, 0.3);
      ++compared;
    }
  EXPECT_GT(compared, 15u);
  EXPECT_LT(found->profile.depth.front(), -40);
}

TEST(DetonationFront, IsFollowedToTheFarEndOnly) {
  Wave wave;
  auto const before = steady_detonation(wave.frames(112), wave.scale(), 0.3);
  wave.comes_back = true;
  auto const after = steady_detonation(wave.frames(180), wave.scale(), 0.3);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(after->times, before->times);
  EXPECT_EQ(after->D.mean, before->D.mean);
}

TEST(DetonationFront, IsNotFoundWhereThereIsNone) {
  Wave wave;
  EXPECT_FALSE(steady_detonation(wave.frames(20), wave.scale(), 0.3)); // too short
  auto shocks = wave.frames(110);
  for (auto& frame : shocks)
    frame.progress.assign(frame.progress.size(), 0.5); // nothing ends its reaction
  EXPECT_FALSE(steady_detonation(shocks, wave.scale(), 0.3));
}

} // namespace
} // namespace mesobridge::sdpd
