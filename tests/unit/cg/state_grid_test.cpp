#include "cg/state_grid.hpp"
#include "md/error.hpp"
#include "unit/cg/ar1.hpp"
#include <gtest/gtest.h>

namespace mesobridge::cg::test {
namespace {

constexpr double rho = 0.7, T = 4.0, u_mean = -3.5, w_mean = 6.0, u_sigma = 0.05;
constexpr int atoms = 500;

/// A made-up fluid: u_pot and the virial pressure are one AR(1) process plus noise of their own, the kinetic
/// temperature is independent and much noisier, and the run begins away from its stationary state.
std::vector<md::ThermoSample> made_up_run(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  auto const a = ar1(n, 0.9, 0.0, generator), b = ar1(n, 0.5, 0.0, generator),
             c = ar1(n, 0.7, 0.0, generator);
  std::vector<md::ThermoSample> samples;
  for (std::size_t i = 0; i < n; ++i) {
    double const T_kin = T + 0.15 * c[i], start = 20 * std::exp(-double(i) / 50);
    double const u = u_mean + u_sigma * (a[i] + start);
    double const w = w_mean + 0.2 * (0.8 * a[i] + 0.6 * b[i] + start);
    samples.push_back({std::int64_t(10 * i), T_kin, u + 1.5 * T_kin, w + rho * T_kin});
  }
  return samples;
}

TEST(StateGrid, RecoversTheMomentsOfAMadeUpRun) {
  double const c_v = 1.5 + atoms * u_sigma * u_sigma / (T * T);
  int U_ok = 0, P_ok = 0, c_v_ok = 0, cases = 0;
  double correlation = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed, ++cases) {
    auto const point = analyse_state(rho, T, atoms, made_up_run(8000, seed));
    U_ok += agrees(point.U, u_mean + 1.5 * T, 2);
    P_ok += agrees(point.P, w_mean + rho * T, 2);
    c_v_ok += agrees(point.c_v, c_v, 2);
    EXPECT_TRUE(agrees(point.T_kin, T, 5));
    EXPECT_GT(point.discarded, 50u);
    EXPECT_EQ(point.discarded + point.samples, 8000u);
    EXPECT_NEAR(point.tau_U, ar1_tau(0.9), 0.4 * ar1_tau(0.9));
    correlation += point.cov_UP / (point.U.se * point.P.se) / 50;
  }
  EXPECT_EQ(cases, 50);
  EXPECT_GE(U_ok, 43); // 95 % of 50 is 47.7 with a standard deviation of 1.5
  EXPECT_GE(P_ok, 43);
  EXPECT_GE(c_v_ok, 43);
  // Means over long times: var a : var b = 0.64 * 19 : 0.36 * 3.
  EXPECT_NEAR(correlation, std::sqrt(0.64 * 19 / (0.64 * 19 + 0.36 * 3)), 0.03);
}

TEST(StateGrid, TheMeasuredKineticNoiseDoesNotReachTheErrors) {
  auto const point = analyse_state(rho, T, atoms, made_up_run(8000, 99));
  double const se_potential = u_sigma * std::sqrt(2 * ar1_tau(0.9) / double(point.samples));
  double const se_kinetic = 1.5 * 0.15 * std::sqrt(2 * ar1_tau(0.7) / double(point.samples));
  EXPECT_NEAR(point.U.se, se_potential, 0.3 * se_potential);
  EXPECT_GT(se_kinetic, 1.5 * se_potential) << "else this test would show nothing";
}

TEST(StateGrid, RefusesAShortRunAndBadStates) {
  auto samples = made_up_run(8000, 3);
  EXPECT_THROW(analyse_state(rho, T, atoms, std::span(samples).first(39)), InputError);
  EXPECT_THROW(analyse_state(rho, T, atoms, std::span(samples).subspan(4000).first(80)), PhysicsError);
  EXPECT_THROW(analyse_state(-1.0, T, atoms, samples), InputError);
  EXPECT_THROW(analyse_state(rho, std::nan(""), atoms, samples), InputError);
  EXPECT_THROW(analyse_state(rho, T, 0, samples), InputError);
  samples[6000].P = std::nan("");
  EXPECT_THROW(analyse_state(rho, T, atoms, samples), InputError);
}

} // namespace
} // namespace mesobridge::cg::test
