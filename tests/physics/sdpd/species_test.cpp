#include "cg/estimate.hpp"
#include "cg/kolmogorov_smirnov.hpp"
#include "pair_fluid_fixtures.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd_fixtures.hpp"
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

/// What the particles of one species were at decorrelated instants: energies in k_B T, momenta in their
/// thermal width.
struct Sampled {
  std::vector<double> energies, momenta, kinetic; ///< the last: T_kin of the species at each instant
};

/// Fluctuation and dissipation alone, at fixed places, from mean energies of T = 1, which are `first` or, if
/// that is empty, as the system has them.
std::vector<Sampled> sample(SimulationSettings settings, std::size_t species, int instants, int between,
                            std::vector<double> const& first = {}) {
  settings.disorder = 0.2;
  auto const system = make_system(settings);
  if (!first.empty()) {
    for (std::size_t i = 0; i < system->size(); ++i)
      system->particles.eps[i] = first[system->particles.species[i]];
    thermodynamics_from_energy(*system);
  }
  auto const& particles = system->particles;
  auto const sweep = pair_integrator(settings.scheme.pairs).sweep;
  std::vector<Sampled> sampled(species);
  for (int k = -20; k < instants; ++k) {
    for (int s = 0; s < between; ++s, ++system->step) {
      sweep(*system, settings.dt, false);
      if (system->has_energies())
        thermodynamics_from_energy(*system);
    }
    if (k < 0)
      continue;
    std::vector<double> sum(species), count(species);
    for (std::size_t i = 0; i < system->size(); ++i) {
      auto& of = sampled[particles.species[i]];
      double const width = std::sqrt(particles.mass[i] * system->boltzmann);
      if (system->has_energies())
        of.energies.push_back(particles.eps[i] / system->boltzmann);
      of.momenta.push_back(particles.p[i].x / width);
      sum[particles.species[i]] += norm2(particles.p[i]) / (3 * width * width), ++count[particles.species[i]];
    }
    for (std::size_t s = 0; s < species; ++s)
      sampled[s].kinetic.push_back(sum[s] / count[s]);
  }
  return sampled;
}

/// Maxwell's law of every species, and equal temperatures.
void expect_maxwell(std::vector<Sampled> const& all) {
  for (auto const& of : all) {
    auto const T = cg::estimate_mean(of.kinetic);
    EXPECT_LT(T.se, 0.01);
    EXPECT_LT(std::abs(T.mean - 1), 4 * T.se + 1e-3) << T.mean << " +- " << T.se; // N - 1 of N are free
    EXPECT_GT(cg::kolmogorov_smirnov_p(of.momenta, [](double x) { return gsl_cdf_ugaussian_P(x); }), 1e-3);
    EXPECT_LT(cg::kolmogorov_smirnov_p(of.momenta, [](double x) { return gsl_cdf_ugaussian_P(1.06 * x); }),
              1e-3); // a width 6 % off fails
  }
}
/// The energies follow Gamma(shape, k_B T).
void expect_gamma(Sampled const& of, double shape) {
  auto law = [](double a, double scale) { return [=](double x) { return gsl_cdf_gamma_P(x, a, scale); }; };
  EXPECT_GT(cg::kolmogorov_smirnov_p(of.energies, law(shape, 1)), 1e-3);
  EXPECT_LT(cg::kolmogorov_smirnov_p(of.energies, law(1.1 * shape, 1 / 1.1)), 1e-3);
}

// EMS is exact at any time step. DPDE's measure is exp(S/k_B) = eps^C: Gamma(C + 1, k_B T).
TEST(SpeciesInEquilibrium, OfTwoMassesAndHeatCapacitiesInDpdeHaveTheExactLaws) {
  auto settings = dpde_ideal(8, 0.5, 2);
  settings.lattice = {10, 10, 10};
  settings.scheme.pairs = "ems";
  settings.rho = 3 * 2.6; // as many particles as in the standard fluid of the mass 1
  DpdeSpecies const light{"light", 0.6, 1, fitting::ConstantHeatCapacity(8)},
      heavy{"heavy", 0.4, 5, fitting::ConstantHeatCapacity(30)};
  settings.as<Dpde>().species = {light, heavy};
  auto const sampled = sample(settings, 2, 60, 40, {8 + 1, 30 + 1});
  ASSERT_EQ(sampled[0].energies.size(), 60u * 600);
  expect_maxwell(sampled);
  expect_gamma(sampled[0], 8 + 1);
  expect_gamma(sampled[1], 30 + 1);
}

// An SDPD fluid of one gas in particles of two sizes: Gamma(C_K/k_B, k_B T), C_K = (3/2)(K - 1) k_B (Eq.
// (S19)).
TEST(SpeciesInEquilibrium, OfTwoSizesInSdpdHaveTheExactLaws) {
  auto settings = ideal_gas(10, 0.5);
  settings.scheme.pairs = "ems";
  auto& fluid = settings.as<Sdpd>();
  fluid.species = {{"small", 0.6, 10, fluid.eos}, {"large", 0.4, 40, fluid.eos}};
  auto const sampled = sample(settings, 2, 100, 20);
  ASSERT_EQ(sampled[1].energies.size(), 100u * 400);
  expect_maxwell(sampled);
  expect_gamma(sampled[0], 1.5 * 9);
  expect_gamma(sampled[1], 1.5 * 39);
}

// Every integrator that is right at any time step.
TEST(SpeciesInEquilibrium, OfTwoMassesInDpdHaveMaxwellsLaw) {
  auto settings = dpd_fluid(1);
  settings.as<Dpd>().friction = PowerFriction(4.5, 3, 1, 2);
  settings.rho = 3 * 4.25;
  settings.as<Dpd>().species = {{"light", 0.5, 0.5}, {"heavy", 0.5, 8}};
  int count = 0;
  for (auto const& pairs : pair_integrators()) {
    if (pairs.short_steps_only || refusal(pairs, settings.features()))
      continue;
    SCOPED_TRACE(pairs.name);
    settings.scheme.pairs = pairs.name;
    expect_maxwell(sample(settings, 2, 100, 30));
    ++count;
  }
  EXPECT_GE(count, 1);
}

} // namespace
} // namespace mesobridge::sdpd
