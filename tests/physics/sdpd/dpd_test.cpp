#include "cg/estimate.hpp"
#include "cg/kolmogorov_smirnov.hpp"
#include "pair_fluid_fixtures.hpp"
#include "physics/sdpd/fluctuating.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/observe/equilibrium.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd/state/pair_counts.hpp"
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

// a = 25, rho = 3, gamma = 4.5: Monte Carlo gives P = 23.652 +- 0.001 (dpd_pressure_test.cpp); Groot and
// Warren's equation of state, rho k_BT + 0.101 a rho^2, gives 25.7, for larger densities.
TEST(Dpd, HasThePressureOfTheStandardFluid) {
  Simulation simulation(dpd_fluid(0.01));
  simulation.advance(300);
  std::vector<double> P, T;
  for (int k = 0; k < 400; ++k) {
    simulation.advance(6);
    auto const now = simulation.observe();
    P.push_back(now.P), T.push_back(now.T_kin);
  }
  auto const pressure = cg::estimate_mean(P), temperature = cg::estimate_mean(T);
  EXPECT_LT(pressure.se, 0.06);
  EXPECT_NEAR(pressure.mean, 23.652, 0.15);
  EXPECT_LT(temperature.se, 0.01);
  EXPECT_NEAR(temperature.mean, 1, 0.01 + 3 * temperature.se);
  RecordProperty("P", std::to_string(pressure.mean) + " +- " + std::to_string(pressure.se));
}

struct Sampled {
  std::vector<double> energies, momenta, inverse_T;
  std::vector<double> kinetic; ///< T_kin at the instants
  PairCounts counts;
};

/// Fluctuation and dissipation alone, at fixed places, from energies whose mean is that at k_BT = 1.
Sampled sample(PairScheme scheme, double C, double dt, double across, int instants, int between) {
  auto settings = dpde_ideal(C, dt, across);
  settings.lattice = {10, 10, 10}, settings.disorder = 0.2;
  auto const system = make_system(settings);
  std::fill(system->particles.eps.begin(), system->particles.eps.end(), C + 1);
  thermodynamics_from_energy(*system);
  Sampled sampled;
  at_instants(*system, scheme, dt, instants, between, [&] {
    double kinetic = 0;
    for (std::size_t i = 0; i < system->size(); ++i) {
      sampled.energies.push_back(system->particles.eps[i]);
      sampled.inverse_T.push_back(1 / system->particles.T[i]);
      sampled.momenta.push_back(system->particles.p[i].x);
      kinetic += norm2(system->particles.p[i]) / (3 * (static_cast<double>(system->size()) - 1));
    }
    sampled.kinetic.push_back(kinetic);
  });
  sampled.counts = system->pair_counts;
  return sampled;
}

struct Case {
  double C, dt, across;
};

class DpdeIdeal : public ::testing::TestWithParam<Case> {};

// S = C ln eps and the measure exp(S/k_B) exp(-eps/k_BT) make eps^C exp(-eps/k_BT): Gamma(C/k_B + 1, k_BT).
// The harmonic mean of T = eps/C is then T exactly, the arithmetic one (C + 1)/C T.
TEST_P(DpdeIdeal, HasTheExactLawsAtAnyTimeStep) {
  auto const [C, dt, across] = GetParam();
  auto const s = sample(PairScheme::ems, C, dt, across, 40, 15);
  ASSERT_EQ(s.energies.size(), 40000u);
  double const shape = C + 1;
  EXPECT_GT(cg::kolmogorov_smirnov_p(s.energies, [&](double x) { return gsl_cdf_gamma_P(x, shape, 1); }),
            1e-3);
  double const of_sdpd = cg::kolmogorov_smirnov_p(
      s.energies, [&](double x) { return gsl_cdf_gamma_P(x, C, shape / C); }); // of the same mean
  EXPECT_TRUE(C > 10 || of_sdpd < 1e-3) << of_sdpd; // too near to tell for larger particles
  EXPECT_GT(cg::kolmogorov_smirnov_p(s.momenta, [](double x) { return gsl_cdf_ugaussian_P(x); }), 1e-3);
  double inverse = 0, kinetic = 0;
  for (double const x : s.inverse_T)
    inverse += x / static_cast<double>(s.inverse_T.size());
  for (double const x : s.kinetic)
    kinetic += x / static_cast<double>(s.kinetic.size());
  // <T^-2> - 1 = 1/(C - 1)
  double const se_int = std::sqrt(1 / (std::max(C - 1, 0.2) * 40000)), se_kin = std::sqrt(2.0 / (3 * 40000));
  EXPECT_NEAR(1 / inverse, 1, 5 * se_int);
  EXPECT_NEAR(kinetic, 1, 5 * se_kin);
  EXPECT_GT(s.counts.metropolis, 0u);
  RecordProperty("rejected", std::to_string(double(s.counts.metropolis) / double(s.counts.proposed)));
}

INSTANTIATE_TEST_SUITE_P(HeatCapacities, DpdeIdeal,
                         ::testing::Values(Case{2, 0.1, 0}, Case{5, 0.2, 3}, Case{10, 0.3, 0},
                                           Case{50, 0.3, 3}),
                         [](auto const& info) { return "C" + std::to_string(int(info.param.C)); });

// The whole dynamics: kinetic and (harmonic) internal temperature agree, the energy stays.
TEST(Dpde, ComesToOneTemperatureAndKeepsItsEnergy) {
  auto settings = dpde_fluid(30, 0.005);
  Simulation simulation(settings);
  equilibrate(simulation, 640, [] { return true; });
  EquilibriumSampler sampler;
  for (int k = 0; k < 300; ++k) {
    simulation.advance(8);
    auto const now = simulation.observe();
    sampler.sample(now, 8 * k * settings.dt);
    if (k % 15 == 0)
      sampler.sample(moments(simulation.snapshot()));
  }
  auto const result = sampler.result();
  EXPECT_LT(result.T_kin.se, 0.03);
  EXPECT_NEAR(result.T_kin.mean, 1, 5 * result.T_kin.se + 0.01);
  EXPECT_NEAR(result.T_kin.mean, result.T_int.mean, 5 * std::hypot(result.T_kin.se, result.T_int.se) + 0.005);
  EXPECT_LT(std::abs(result.drift.rate), 1e-4);
  auto const energies = sampler.energies();
  EXPECT_NEAR(energies.back() / energies.front(), 1, 1e-3);
}

} // namespace
} // namespace mesobridge::sdpd
