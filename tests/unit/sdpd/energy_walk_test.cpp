#include "sdpd/observe/energy_walk.hpp"
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::sdpd {
namespace {

/// A random walk of the energy with <W^2> = 2 D t, and an error of a given size and memory that only wanders.
struct Walk {
  std::vector<double> times, energies;

  Walk(double D, double wander, double memory, std::size_t n, double interval) {
    std::mt19937_64 generator(7);
    std::normal_distribution<double> G;
    double energy = 1000, error = 0;
    double const forget = std::exp(-interval / memory);
    for (std::size_t k = 0; k < n; ++k) {
      times.push_back(static_cast<double>(k) * interval), energies.push_back(energy + error);
      energy += std::sqrt(2 * D * interval) * G(generator);
      error = forget * error + wander * std::sqrt(1 - forget * forget) * G(generator);
    }
  }
};

// <W> = Var(W) / 2 k_B T: here Var(W)/t = 2 D, so the relative rate is D / (k_B T |E_0|).
TEST(EnergyWalk, TellsTheDriftFromTheWalkAndNotFromErrorsThatWander) {
  double const D = 2e-4, kT = 0.1;
  Walk const walk(D, 0.02, 0.5, 20000, 0.5);
  auto const drift = drift_from_energy_walk(walk.times, walk.energies, 3, 0.05, kT / 0.05);
  double const expected = D / (kT * 1000);
  EXPECT_LT(drift.se, 0.1 * expected);
  EXPECT_LT(std::abs(drift.rate - expected), 4 * drift.se);
  EXPECT_GT(std::abs(drift.rate - 2 * expected), 4 * drift.se); // half the heat would be seen
  Walk const bounded(0, 0.02, 0.5, 20000, 0.5);
  auto const none = drift_from_energy_walk(bounded.times, bounded.energies, 3, 0.05, kT / 0.05);
  EXPECT_LT(std::abs(none.rate), 4 * none.se);
  EXPECT_LT(none.se, 0.2 * expected);
}

TEST(EnergyWalk, RefusesShortSeries) {
  Walk const walk(1, 0, 1, 100, 1);
  EXPECT_NO_THROW(drift_from_energy_walk(walk.times, walk.energies, 3, 1, 1));
  EXPECT_THROW(drift_from_energy_walk(walk.times, walk.energies, 4, 1, 1), InputError);
}

// 3/0.4 rounds up to a lag of 8 samples: 256 samples are 102 units of time, which is 34 lags of 3, but not
// more than 32 of 8 samples.
TEST(EnergyWalk, SaysHowManySamplesItNeeds) {
  std::vector<double> times, energies;
  for (int k = 0; k < 257; ++k)
    times.push_back(0.4 * k), energies.push_back(1 + 1e-6 * (k % 7));
  EXPECT_TRUE(enough_for_energy_walk(times, 3));
  EXPECT_NO_THROW(drift_from_energy_walk(times, energies, 3, 1, 1));
  times.pop_back(), energies.pop_back();
  EXPECT_FALSE(enough_for_energy_walk(times, 3));
  EXPECT_THROW(drift_from_energy_walk(times, energies, 3, 1, 1), InputError);
  EXPECT_FALSE(enough_for_energy_walk(std::span(times).first(1), 3));
}

} // namespace
} // namespace mesobridge::sdpd
