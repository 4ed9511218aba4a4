#include "fitting/fit_dpde.hpp"
#include "md/error.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::fitting::test {
namespace {

/// Energies of a molecule whose C = n - 1 is the same at any temperature: Gamma(n, T).
cg::EntropyFit constant(double n) {
  std::mt19937_64 generator(4);
  std::vector<cg::EnergySamples> samples;
  for (double T : {0.8, 1.2}) {
    std::gamma_distribution<double> energy(n, T);
    cg::EnergySamples set{.beta = 1 / T, .U = {}, .U_kin = {}, .beta_without = {}};
    for (int block = 0; block < 20; ++block) {
      set.U.emplace_back();
      for (int k = 0; k < 1000; ++k)
        set.U.back().push_back(energy(generator));
    }
    samples.push_back(std::move(set));
  }
  return cg::fit_entropy(samples, cg::EntropyRoute::density, 19, {.order = 2});
}

TEST(FitDpde, AConstantHeatCapacityIsFoundWithItsErrorsAndGoesOnBeyondTheSamples) {
  auto const fit = fit_dpde(constant(40), {});
  ASSERT_EQ(fit.T_table.size(), 35u);
  EXPECT_EQ(fit.T_table.front(), 0.05);
  EXPECT_EQ(fit.T_table.back(), 10);
  int points = 0;
  for (std::size_t k = 0; k < fit.T.size(); ++k, ++points) {
    EXPECT_TRUE(cg::agrees(fit.C[k], 39, 4.5)) << fit.C[k].mean << " +- " << fit.C[k].se;
    EXPECT_TRUE(cg::agrees(fit.eps[k], 39 * fit.T[k], 4.5)) << fit.eps[k].mean;
    EXPECT_NEAR(std::sqrt(fit.covariance[k][k]), fit.C[k].se, 1e-6 * fit.C[k].se);
    EXPECT_DOUBLE_EQ(fit.covariance[0][k], fit.covariance[k][0]);
  }
  EXPECT_EQ(points, 33);
  for (double const C : fit.C_table)
    EXPECT_GT(C, 0);
  // The table's energy at the lowest sampled T is that of the curve.
  EXPECT_NEAR(fit.eps_min + fit.C_table[0] * (fit.T[0] - 0.05), fit.eps[0].mean, 0.1);
}

TEST(FitDpde, TheParticleHasTheTable) {
  auto const fit = fit_dpde(constant(40), {.points = 5});
  auto const particle = internal_energy_of(fit);
  EXPECT_EQ(particle.temperatures(), fit.T_table);
  EXPECT_EQ(particle.heat_capacities(), fit.C_table);
  EXPECT_EQ(particle.eps_min(), fit.eps_min);
  EXPECT_NEAR(particle.energy(1), 39, 4.5 * fit.eps[2].se);
}

TEST(FitDpde, RefusesARangeThatLeavesSamplesOut) {
  auto const fit = constant(40);
  EXPECT_THROW(fit_dpde(fit, {.T_min = 0.9}), InputError);
  EXPECT_THROW(fit_dpde(fit, {.T_max = 1.0}), InputError);
  EXPECT_THROW(fit_dpde(fit, {.T_min = -1}), InputError);
  EXPECT_THROW(fit_dpde(fit, {.points = 2}), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
