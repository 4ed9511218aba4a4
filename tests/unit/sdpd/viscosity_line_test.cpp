#include "sdpd/setup/viscosity_line.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace mesobridge::sdpd {
namespace {

double truth(double pairs) {
  return 0.1 + 0.8 * pairs;
}

/// Trials as a search for the viscosity 1 makes them, which ends where the last one comes out right.
std::vector<ViscosityTrial> search(std::mt19937_64& generator) {
  std::normal_distribution<double> G;
  std::vector<ViscosityTrial> trials;
  auto const measure = [&](double pairs, double se) {
    trials.push_back({pairs, {truth(pairs) + se * G(generator), se, 50}});
    return trials.back().realised.mean;
  };
  double pairs = 1, y = measure(pairs, 0.03);
  pairs += 1 - y, y = measure(pairs, 0.03);
  do
    pairs += 1 - y, y = measure(pairs, 0.02);
  while (std::abs(y - 1) > 0.025);
  return trials;
}

TEST(ViscosityLine, IsNearerToTheTruthThanTheTrialThatEndsASearchAndKnowsItsError) {
  std::mt19937_64 generator(5);
  constexpr int searches = 4000;
  double of_line = 0, of_last = 0, z2 = 0;
  for (int k = 0; k < searches; ++k) {
    auto const trials = search(generator);
    double const pairs = trials.back().pairs, exact = truth(pairs);
    auto const found = realised_by_line(trials, pairs);
    of_line += std::pow(found.mean - exact, 2), of_last += std::pow(trials.back().realised.mean - exact, 2);
    z2 += std::pow((found.mean - exact) / found.se, 2);
  }
  EXPECT_LT(of_line, 0.9 * of_last);
  EXPECT_NEAR(std::sqrt(z2 / searches), 1, 0.1);
}

TEST(ViscosityLine, GoesThroughTrialsOfALineAndLeavesOutThoseFarAway) {
  std::vector<ViscosityTrial> trials{
      {0.9, {truth(0.9), 1e-6, 40}}, {1.1, {truth(1.1), 1e-6, 40}}, {2, {17, 1e-6, 40}}};
  auto const found = realised_by_line(trials, 1);
  EXPECT_NEAR(found.mean, truth(1), 1e-6);
  EXPECT_EQ(found.n_eff, 80);
  trials.erase(trials.begin(), trials.begin() + 1);
  trials[0].realised.se = 0.02;
  auto const alone = realised_by_line(trials, 1.1);
  EXPECT_NEAR(alone.mean, truth(1.1), 1e-12);
  EXPECT_NEAR(alone.se, 0.02, 1e-12);
  auto const beside = realised_by_line(trials, 1); // where the slope 1 +- 1/2 has to serve
  EXPECT_NEAR(beside.mean, truth(1.1) - 0.1, 1e-12);
  EXPECT_NEAR(beside.se, std::hypot(0.02, 0.05), 1e-12);
}

} // namespace
} // namespace mesobridge::sdpd
