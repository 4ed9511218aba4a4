#include "md/error.hpp"
#include "sdpd/observe/equilibrium.hpp"
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::sdpd {
namespace {

struct Trace {
  std::vector<double> times, energies;
};

/// An energy that drifts at a known rate under a noise with memory.
Trace drifting(double rate, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  Trace trace;
  double memory = 0;
  for (int k = 0; k < 2000; ++k) {
    memory = 0.9 * memory + 1e-6 * gauss(random);
    trace.times.push_back(0.1 * k);
    trace.energies.push_back(50 * (1 + rate * 0.1 * k + memory));
  }
  return trace;
}

TEST(EnergyDrift, FindsAKnownRateWithinItsErrors) {
  int covered = 0, repeats = 0;
  double const rate = 3e-7;
  for (unsigned seed = 1; seed <= 100; ++seed, ++repeats) {
    auto const trace = drifting(rate, seed);
    auto const drift = energy_drift(trace.times, trace.energies);
    // E_0 itself is a noisy sample, which shifts all rates by no more than 1e-5 of themselves.
    covered += std::abs(drift.rate - rate) < 2.36 * drift.se; // 95 % of Student's t with 7 degrees of freedom
    EXPECT_GT(std::abs(drift.rate - 2 * rate), 5 * drift.se / 3);
  }
  EXPECT_EQ(repeats, 100);
  EXPECT_GE(covered, 90);
}

TEST(EnergyDrift, IsMeasuredBeforeTheFluidHasHeated) {
  std::vector<double> const energies{5, 5.01, 4.99, 5.02, 5.3, 5.0, std::nan("")};
  EXPECT_EQ(samples_before_heating(energies, 0.1), 4u); // not what comes back
  EXPECT_EQ(samples_before_heating(energies, 0.005), 1u);
  EXPECT_EQ(samples_before_heating(energies, 1), 6u); // no number is far from all
  EXPECT_EQ(samples_before_heating(std::span(energies).first(4), 0.1), 4u);
}

TEST(EnergyDrift, RefusesTooFewSamples) {
  std::vector<double> const few(31, 1.0);
  EXPECT_THROW(energy_drift(few, few), InputError);
}

TEST(InstantMoments, AreMeansAndVariancesOverTheParticles) {
  Snapshot now;
  now.eps = {1, 2, 3}, now.rho = {2, 2, 5}, now.P = {-1, 0, 1};
  auto const m = moments(now);
  EXPECT_DOUBLE_EQ(m.eps_mean, 2);
  EXPECT_DOUBLE_EQ(m.eps_variance, 1);
  EXPECT_DOUBLE_EQ(m.rho_mean, 3);
  EXPECT_DOUBLE_EQ(m.rho_variance, 3);
  EXPECT_DOUBLE_EQ(m.P_mean, 0);
  EXPECT_DOUBLE_EQ(m.P_variance, 1);
}

} // namespace
} // namespace mesobridge::sdpd
