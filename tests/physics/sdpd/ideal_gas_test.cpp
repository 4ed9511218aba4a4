#include "cg/estimate.hpp"
#include "cg/kolmogorov_smirnov.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_fixtures.hpp"
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

struct Series {
  std::vector<double> T_kin, T_int, P,
      energies; ///< energies: all particles at decorrelated instants, in k_B T
};

Series run(SimulationSettings const& settings, std::uint64_t equilibrate_for, int instants,
           std::uint64_t between) {
  Simulation simulation(settings);
  equilibrate(simulation, equilibrate_for, [] { return true; });
  Series series;
  for (int k = 0; k < instants; ++k) {
    for (std::uint64_t s = 0; s < between; s += 5) {
      simulation.advance(5);
      auto const now = simulation.observe();
      series.T_kin.push_back(now.T_kin), series.T_int.push_back(now.T_int), series.P.push_back(now.P);
    }
    for (double const eps : simulation.snapshot().eps)
      series.energies.push_back(eps * settings.K()); // reduced energies count in K k_B T
  }
  return series;
}

class IdealGas : public ::testing::TestWithParam<SimulationSettings> {};

// Exact answers: eps follows Gamma(C_K/k_B, k_B T) with C_K = (3/2)(K-1) k_B (sdpd/README.md, Eq. (S19)), and
// both temperatures equal the set one.
TEST_P(IdealGas, HasTheGammaLawAndTheSetTemperatures) {
  auto const settings = GetParam();
  auto const series = run(settings, 800, 12, 100);
  double const shape = 1.5 * (settings.K() - 1);
  auto gamma_law = [](double a) { return [a](double x) { return gsl_cdf_gamma_P(x, a, 1); }; };
  ASSERT_EQ(series.energies.size(), 12000u);
  EXPECT_GT(cg::kolmogorov_smirnov_p(series.energies, gamma_law(shape)), 1e-3);
  EXPECT_LT(cg::kolmogorov_smirnov_p(series.energies, gamma_law(1.5 * settings.K())),
            1e-3); // K instead of K-1 fails

  for (auto const* T : {&series.T_kin, &series.T_int}) {
    auto const estimate = cg::estimate_mean(*T);
    EXPECT_GT(estimate.n_eff, 20);
    EXPECT_LT(std::abs(estimate.mean - 1), std::max(3 * estimate.se, 0.003));
    EXPECT_LT(estimate.se, 0.004);
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, IdealGas, ::testing::Values(ideal_gas(10, 0.04), ideal_gas(100, 0.1)),
                         [](auto const& info) { return "K" + std::to_string(int(info.param.K())); });

} // namespace
} // namespace mesobridge::sdpd
