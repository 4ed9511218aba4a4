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

} // namespace
} // namespace mesobridge::sdpd
