#include "cg/estimate.hpp"
#include "fitting/eos/evaluate.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/observe/pairing.hpp"
#include "sdpd/setup/calibrate_density.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_fixtures.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <iostream>
#include <numeric>

// What a fluid gets whose user says nothing of kernels and densities.

namespace mesobridge::sdpd {
namespace {

SimulationSettings argon_by_default(double K, double dt, std::uint32_t side) {
  auto settings = argon(K, dt);
  settings.as<Sdpd>().kernel = Sdpd{.eos = fitting::IdealGas(1)}.kernel;
  settings.lattice = {side, side, side};
  settings.disorder = 0.15;
  return settings;
}

/// P and rho in units of the equation of state's; shares of paired particles.
struct Means {
  cg::Estimate P, rho;
  double pairing_first, pairing_last; ///< in the first and the last quarter
};

double mean(std::vector<double> const& x, std::size_t begin, std::size_t end) {
  return std::accumulate(x.begin() + static_cast<std::ptrdiff_t>(begin),
                         x.begin() + static_cast<std::ptrdiff_t>(end), 0.0) /
         static_cast<double>(end - begin);
}

Means measure(SimulationSettings const& settings, std::uint64_t settle, std::uint64_t steps) {
  Simulation simulation(settings);
  equilibrate(simulation, settle, [] { return true; });
  double const P_eos = std::visit(
      [&](auto const& model) { return fitting::state_from_temperature(model, settings.rho, settings.T).P; },
      settings.as<Sdpd>().eos);
  std::vector<double> P, rho, pairing;
  for (std::uint64_t k = 0; k < steps; k += 5) {
    simulation.advance(5);
    auto const now = simulation.observe();
    P.push_back(now.P * settings.units().pressure() / P_eos), rho.push_back(now.rho);
    if (k % 50 == 0)
      pairing.push_back(simulation.pairing_fraction());
  }
  auto const n = pairing.size();
  return {cg::estimate_mean(P), cg::estimate_mean(rho), mean(pairing, 0, n / 4), mean(pairing, n - n / 4, n)};
}

void expect_a_good_fluid(double K, double dt, std::uint32_t side, std::uint64_t calibration,
                         std::uint64_t settle, std::uint64_t steps) {
  SCOPED_TRACE("K = " + std::to_string(K));
  auto settings = argon_by_default(K, dt, side);
  auto const never = [] { return true; };
  ASSERT_EQ(suitable_condition(settings), ScaleCondition::pressure);
  settings.as<Sdpd>().density_correction =
      calibrate_density(settings, ScaleCondition::pressure, calibration, never).constants;
  settings.seed = 7; // another history than the calibration's
  auto const [P, rho, first, last] = measure(settings, settle, steps);
  EXPECT_NEAR(P.mean, 1, 0.005);
  EXPECT_NEAR(rho.mean, 1, 0.003);
  EXPECT_LT(P.se, 0.0015);
  EXPECT_LT(rho.se, 0.002);
  EXPECT_LT(first, 0.01);
  EXPECT_LT(last, 0.01);
  std::cout << fmt::format(
      "K = {:g}: P/P_eos {:.5f} +- {:.5f}, rho/rho_0 {:.5f} +- {:.5f}, pairs {:.4f} -> {:.4f}\n", K, P.mean,
      P.se, rho.mean, rho.se, first, last);
}

TEST(DefaultKernel, GivesPressureAndDensityOfTheEquationOfStateWithoutPairs) {
  int cases = 0;
  for (auto const& [K, dt] : {std::pair(10.0, 0.03), {1000.0, 0.1}}) {
    expect_a_good_fluid(K, dt, 8, 800, 200, 800);
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

TEST(DefaultKernel, IsNotTheCubicOneWhichPairs) {
  auto settings = argon_by_default(1000, 0.1, 7);
  settings.as<Sdpd>().kernel = "cubic";
  EXPECT_GT(measure(settings, 200, 1000).pairing_last, tolerable_pairing(1000));
}

TEST(SuitableCondition, GoesByThePressureOfTheFluid) {
  struct Case {
    double rho, T;
    std::optional<ScaleCondition> condition;
  };
  std::vector<Case> const cases{{1150, 1000, ScaleCondition::pressure},
                                {1150, 300, ScaleCondition::pressure},
                                {1400, 87, ScaleCondition::response}, // at its boiling point
                                {1150, 90, std::nullopt}};            // torn apart: it would boil
  for (auto const& [rho, T, condition] : cases) {
    auto settings = argon_by_default(100, 0.03, 8);
    settings.rho = rho, settings.T = T;
    EXPECT_EQ(suitable_condition(settings), condition) << rho << " kg/m^3, " << T << " K";
  }
  EXPECT_EQ(cases.size(), 4u);
}

// 10^4 reduced times at the time step of the shipped scene.
class Long_DefaultKernelOfSize : public ::testing::TestWithParam<double> {};

TEST_P(Long_DefaultKernelOfSize, HoldsForTenThousandReducedTimes) {
  expect_a_good_fluid(GetParam(), 0.03, 10, 6000, 2000, 333333);
}
INSTANTIATE_TEST_SUITE_P(Long_Sizes, Long_DefaultKernelOfSize, ::testing::Values(10, 100, 1000, 10000),
                         [](auto const& info) { return "K" + std::to_string(static_cast<int>(info.param)); });

TEST(Long_DefaultKernel, IsNeededBecauseTheCubicOneGoesOnPairing) {
  auto settings = argon_by_default(1000, 0.03, 10);
  settings.as<Sdpd>().kernel = "cubic";
  auto const means = measure(settings, 2000, 30000);
  EXPECT_GT(means.pairing_last, means.pairing_first + 0.05);
  EXPECT_GT(means.pairing_last, 0.2);
}

} // namespace
} // namespace mesobridge::sdpd
