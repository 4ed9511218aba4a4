#include "md/error.hpp"
#include "sdpd/observe/set_energy.hpp"
#include "sdpd_fixtures.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::sdpd {
namespace {

/// A run of which everything is known: both temperatures scatter independently by `scatter` at every sample,
/// and the energy gains `gain` evenly.
EquilibriumSampler run_of(std::size_t samples, double scatter, double gain, SetEnergy const& set) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> gauss;
  EquilibriumSampler sampler;
  for (std::size_t k = 0; k < samples; ++k) {
    double const gained = gain * double(k) / double(samples - 1), warmer = gained / set.capacity;
    sampler.sample(double(k), 500 + gained, 1 + warmer + scatter * gauss(random),
                   1 + warmer + scatter * gauss(random), 3);
  }
  return sampler;
}

SetEnergy const half_and_half{
    .last_part = 25, .kinetic_capacity = 50, .capacity = 100, .pressure_slope = 2, .particles = 10};

TEST(SetEnergy, HasTheErrorOfTheLastPartOfTheEquilibration) {
  // 25 samples, of a temperature of all that scatters by 0.01/2^(1/2): 0.01/50^(1/2)
  auto const error = set_temperature_error(run_of(4000, 0.01, 0, half_and_half), half_and_half);
  EXPECT_NEAR(error, 0.01 / std::sqrt(50.0), 1.5e-4);
}

TEST(SetEnergy, HasNoMoreErrorThanOneSample) {
  auto short_part = half_and_half;
  short_part.last_part = 0.01;
  auto const error = set_temperature_error(run_of(4000, 0.01, 0, short_part), short_part);
  EXPECT_NEAR(error, 0.01 / std::sqrt(2.0), 3e-4);
}

TEST(SetEnergy, CountsWhatTimeStepsHaveAdded) {
  auto const error = set_temperature_error(run_of(400, 1e-9, 3, half_and_half), half_and_half);
  EXPECT_NEAR(error, 1.5 / 100, 1e-6); // half of the gain in the mean
}

TEST(SetEnergy, GoesIntoTheErrorsOfWhatHangsOnIt) {
  Equilibrium means{.T_kin = {1, 0.03, 50}, .T_int = {1, 0, 50}, .P = {3, 0.06, 50}};
  add_error_of_set_energy(means, 0.04, half_and_half);
  EXPECT_DOUBLE_EQ(means.T_kin.se, 0.05);
  EXPECT_DOUBLE_EQ(means.T_int.se, 0.04);
  EXPECT_DOUBLE_EQ(means.P.se, 0.1);
  EXPECT_DOUBLE_EQ(means.eps.mean.se, 0.2);
  EXPECT_EQ(means.rho.mean.se, 0);
  EXPECT_EQ(means.T_int.n_eff, 50);
}

TEST(SetEnergy, KnowsThePressureOfAnIdealGas) {
  auto const settings = ideal_gas(5, 0.1);
  EXPECT_NEAR(pressure_slope(settings), 1, 1e-9); // P = T for K atoms in a volume of one
}

TEST(SetEnergy, RefusesTooFewSamples) {
  EXPECT_THROW(set_temperature_error(run_of(31, 0.01, 0, half_and_half), half_and_half), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
