#include "sdpd/observe/shock_front.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::sdpd {
namespace {

constexpr double v_P = 3, v_S = 7, noise = 0.2;
constexpr int slices = 200;

ShockScale scale() {
  ShockScale of{.position = {}, .v_P = v_P, .spacing = 1};
  for (int s = 0; s < slices; ++s)
    of.position.push_back(s + 0.5);
  return of;
}

/// A smooth front on its way, known everywhere, with noise in all slices.
std::vector<ShockFrame> moving_front(int frames) {
  std::mt19937 generator(5);
  std::normal_distribution<double> G(0, noise);
  std::vector<ShockFrame> all;
  for (int k = 0; k < frames; ++k) {
    ShockFrame frame{.time = 0.4 * k, .piston = v_P * 0.4 * k, .velocity = {}, .rho = {}, .P = {}, .T = {}};
    for (double const z : scale().position) {
      double const part = 0.5 * (1 - std::tanh((z - v_S * frame.time) / 2));
      frame.velocity.push_back(v_P * part + G(generator)),
          frame.rho.push_back(1 + 0.75 * part + 0.1 * G(generator)); // mass is conserved
      frame.P.push_back(2 + 21 * part + G(generator)), frame.T.push_back(1 + part + G(generator));
    }
    all.push_back(frame);
  }
  return all;
}

TEST(ShockFront, IsFoundByTheLastCrossingFromAhead) {
  auto frame = moving_front(30)[20];
  double const front = v_S * frame.time;
  EXPECT_NEAR(*front_position(frame, scale()), front, 4 * noise * 4 / v_P); // slope v_P/4
  frame.velocity[20] = 0; // a hole behind the front does not matter
  EXPECT_NEAR(*front_position(frame, scale()), front, 4 * noise * 4 / v_P);
  frame.velocity.back() = v_P;
  EXPECT_FALSE(front_position(frame, scale()));
  frame.velocity.assign(slices, 0.0);
  EXPECT_FALSE(front_position(frame, scale()));
}

TEST(SteadyShock, HasTheVelocityAndTheStateOfTheFront) {
  auto const shock = steady_shock(moving_front(80), scale());
  ASSERT_TRUE(shock);
  EXPECT_GT(shock->times.size(), 30u);
  for (auto const& [found, exact] : {std::pair(shock->v_S, v_S),
                                     {shock->v_S_gibbs, v_S},
                                     {shock->rho, 1.75},
                                     {shock->P, 23.0},
                                     {shock->T, 2.0}}) {
    EXPECT_GT(found.se, 0);
    EXPECT_LT(found.se, 0.02 * exact);
    EXPECT_LT(std::abs(cg::deviation(found, exact)), 6); // an error of six blocks is known to 30 %
    EXPECT_GT(std::abs(cg::deviation(found, 1.08 * exact)), 6);
  }
}

// What the start has left before the piston moves with it, and shifts Gibbs's surface by as much in all
// frames.
TEST(SteadyShock, HasTheVelocityOfGibbssSurfaceWhateverIsAtThePiston) {
  auto frames = moving_front(80);
  for (auto& frame : frames)
    for (std::size_t s = 0; s < frame.rho.size(); ++s)
      if (double const depth = scale().position[s] - frame.piston; depth < 12) {
        frame.rho[s] += depth < -0.5 ? -10 : -0.5 * std::exp(-depth / 3);
      }
  auto const shock = steady_shock(frames, scale());
  ASSERT_TRUE(shock);
  EXPECT_LT(shock->v_S_gibbs.se, 0.02 * v_S);
  EXPECT_LT(std::abs(cg::deviation(shock->v_S_gibbs, v_S)), 6);
}

// Densities alone place it, whatever the velocities say.
TEST(SteadyShock, HasTheVelocityOfGibbssSurfaceByTheDensities) {
  constexpr double of_density = 6.8;
  auto frames = moving_front(80);
  for (auto& frame : frames)
    for (std::size_t s = 0; s < frame.rho.size(); ++s)
      frame.rho[s] = scale().position[s] < of_density * frame.time ? 6 : 3;
  auto const shock = steady_shock(frames, scale());
  ASSERT_TRUE(shock);
  EXPECT_NEAR(shock->v_S_gibbs.mean, of_density, 0.03);
  EXPECT_NEAR(shock->v_S.mean, v_S, 0.03);
}

/// Parts of the matter behind the front differ and stay as they are: all frames see the same few.
TEST(SteadyShock, HasTheErrorOfWhatDoesNotChangeFromFrameToFrame) {
  auto frames = moving_front(80);
  std::mt19937 generator(11);
  std::normal_distribution<double> G(0, 0.15);
  std::vector<double> of_parts;
  for (int k = 0; k < 60; ++k)
    of_parts.push_back(G(generator));
  for (auto& frame : frames)
    for (int s = 0; s < slices; ++s)
      if (double const z = s + 0.5 - frame.piston; z > 0 && z < 300)
        frame.rho[std::size_t(s)] += of_parts[std::size_t(z / 5)];
  auto const shock = steady_shock(frames, scale());
  ASSERT_TRUE(shock);
  // The plateau grows to 16 parts, of which the last ones are seen for a short time.
  EXPECT_GT(shock->rho.se, 0.15 / std::sqrt(30));
  EXPECT_LT(shock->rho.se, 0.15 / std::sqrt(3));
  EXPECT_LT(std::abs(cg::deviation(shock->rho, 1.75)), 3.5);
  EXPECT_GT(shock->rho.se, 2 * steady_shock(moving_front(80), scale())->rho.se);
  EXPECT_EQ(shock->P.se, steady_shock(moving_front(80), scale())->P.se); // whose parts are alike
}

/// Slices wider than the plateau of the first frames: no centre of one lies in it.
TEST(SteadyShock, LeavesOutFramesWhosePlateauHoldsNoSlice) {
  constexpr int wide = 20;
  auto fine = scale();
  ShockScale coarse{.position = {}, .v_P = v_P, .spacing = 1};
  for (int s = 0; s < slices; s += wide)
    coarse.position.push_back(s + wide / 2.0);
  auto const mean = [&](std::vector<double> const& of, std::size_t first) {
    double sum = 0;
    for (std::size_t s = first; s < first + wide; ++s)
      sum += of[s] / wide;
    return sum;
  };
  std::vector<ShockFrame> frames;
  for (auto const& of : moving_front(80)) {
    ShockFrame frame{.time = of.time, .piston = of.piston, .velocity = {}, .rho = {}, .P = {}, .T = {}};
    for (std::size_t s = 0; s < slices; s += wide)
      frame.velocity.push_back(mean(of.velocity, s)), frame.rho.push_back(mean(of.rho, s)),
          frame.P.push_back(mean(of.P, s)), frame.T.push_back(mean(of.T, s));
    frames.push_back(frame);
  }
  auto const shock = steady_shock(frames, coarse);
  ASSERT_TRUE(shock);
  EXPECT_LT(shock->times.size(), steady_shock(moving_front(80), fine)->times.size());
  for (auto const& [found, exact] : {std::pair(shock->rho, 1.75), {shock->P, 23.0}, {shock->T, 2.0}})
    EXPECT_LT(std::abs(cg::deviation(found, exact)), 6);
}

TEST(SteadyShock, KnowsItsFramesWhereSomeBetweenThemHaveNoFront) {
  auto frames = moving_front(80);
  auto const all = steady_shock(frames, scale());
  ASSERT_TRUE(all);
  auto const lost = all->frames[10];
  frames[lost].velocity.back() = v_P;
  auto const shock = steady_shock(frames, scale());
  ASSERT_TRUE(shock);
  ASSERT_EQ(shock->frames.size(), all->frames.size() - 1);
  for (std::size_t k = 0; k < shock->frames.size(); ++k) {
    EXPECT_NE(shock->frames[k], lost);
    EXPECT_EQ(shock->times[k], frames[shock->frames[k]].time);
  }
}

TEST(SteadyShock, NeedsEnoughFramesThatAreFarFromBothEnds) {
  EXPECT_FALSE(steady_shock(moving_front(30), scale()));
  EXPECT_FALSE(steady_shock({}, scale()));
  auto const shock = steady_shock(moving_front(80), scale());
  ASSERT_TRUE(shock);
  EXPECT_GT(shock->fronts.front(), v_P * shock->times.front() + 40);
  EXPECT_LT(shock->fronts.back(), slices - 10);
}

} // namespace
} // namespace mesobridge::sdpd
