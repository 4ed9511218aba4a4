#include "cg/estimate.hpp"
#include "cg/kolmogorov_smirnov.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/langevin.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd_fixtures.hpp"
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

// The bath alone: momenta have Maxwell's law at any time step, and energies the Gamma law, Eq. (S19), for
// steps short beside 1/gamma; the centre of mass stays at rest.
TEST(LangevinBath, LeadsToTheCanonicalLawsFromAnotherTemperature) {
  double const K = 10, shape = 1.5 * (K - 1);
  auto const system = make_system(ideal_gas(K, 0.1));
  for (std::size_t i = 0; i < system->size(); ++i)
    system->particles.eps[i] *= 2, system->particles.p[i] *= 0.1;
  thermodynamics_from_energy(*system);
  std::vector<double> energies, momenta;
  for (int k = -100; k < 400; ++k, ++system->step) {
    couple_to_bath(*system, 1, 0.1);
    thermodynamics_from_energy(*system);
    if (k < 0 || k % 20 != 0)
      continue;
    Vec3 sum{};
    for (std::size_t i = 0; i < system->size(); ++i) {
      energies.push_back(system->particles.eps[i] * K);
      momenta.push_back(system->particles.p[i].x * std::sqrt(K));
      sum += system->particles.p[i];
    }
    ASSERT_LT(norm(sum), 1e-12);
  }
  ASSERT_EQ(energies.size(), 20000u);
  auto law = [](double a) { return [a](double x) { return gsl_cdf_gamma_P(x, a, 1); }; };
  EXPECT_GT(cg::kolmogorov_smirnov_p(energies, law(shape)), 1e-3);
  EXPECT_LT(cg::kolmogorov_smirnov_p(energies, law(shape + 0.5)), 1e-3);
  EXPECT_GT(cg::kolmogorov_smirnov_p(momenta, [](double x) { return gsl_cdf_ugaussian_P(x); }), 1e-3);
  EXPECT_LT(cg::kolmogorov_smirnov_p(momenta, [](double x) { return gsl_cdf_ugaussian_P(1.06 * x); }), 1e-3);
}

// A run that was brought to equilibrium by the bath has both temperatures, as one by rescaling has.
TEST(LangevinBath, BringsAFluidToEquilibrium) {
  auto settings = argon(10, 0.04);
  settings.bath_rate = 1;
  Simulation simulation(settings);
  equilibrate(simulation, 600, [] { return true; });
  std::vector<double> T_kin, T_int;
  for (int k = 0; k < 200; ++k) {
    simulation.advance(2);
    auto const now = simulation.observe();
    T_kin.push_back(now.T_kin), T_int.push_back(now.T_int);
  }
  int compared = 0;
  for (auto const* T : {&T_kin, &T_int}) {
    auto const estimate = cg::estimate_mean(*T);
    EXPECT_LT(std::abs(estimate.mean - 1), std::max(4 * estimate.se, 0.006)) << compared;
    ++compared;
  }
  EXPECT_EQ(compared, 2);
  EXPECT_LT(norm(simulation.observe().momentum), 1e-11);
}

TEST(LangevinBath, RefusesANegativeRateAndAFluidWithoutNoise) {
  auto settings = argon(10, 0.04);
  settings.bath_rate = -1;
  EXPECT_THROW(Simulation{settings}, InputError);
  settings.bath_rate = 1, settings.noise = false;
  EXPECT_THROW(Simulation{settings}, InputError);
}

} // namespace
} // namespace mesobridge::sdpd
