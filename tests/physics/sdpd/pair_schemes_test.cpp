#include "cg/kolmogorov_smirnov.hpp"
#include "physics/sdpd/fluctuating.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/state/pair_counts.hpp"
#include "sdpd_fixtures.hpp"
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

/// Fluctuation and dissipation alone, at fixed places: internal energies of all particles, in k_B T, at
/// decorrelated instants, and one component of the momenta in their thermal width.
struct Sampled {
  std::vector<double> energies, momenta;
  PairCounts counts;

  /// Variance of the energies over that of the Gamma law, and its standard error.
  double width(double shape) const {
    double const n = static_cast<double>(energies.size());
    double const mean = std::accumulate(energies.begin(), energies.end(), 0.0) / n;
    double square = 0;
    for (double const x : energies)
      square += (x - mean) * (x - mean) / n;
    return square / shape;
  }
  double width_se(double shape) const {
    return std::sqrt((2 + 6 / shape) / static_cast<double>(energies.size()));
  }
};

/// Who works on the pairs: the built-in engine, or blocks of cells as on many ranks.
enum class By { engine, blocks };

Sampled sample(By by, PairScheme scheme, double K, double dt, int instants, int between) {
  auto settings = ideal_gas(K, dt);
  settings.disorder = 0.2, settings.lattice = {11, 11, 11}; // four ranges along each axis
  auto const system = make_system(settings);
  SweepInBlocks in_blocks(*system, settings);
  auto const sweep = [&] { by == By::engine ? fluctuate(*system, scheme, dt) : in_blocks(scheme, dt); };
  Sampled sampled;
  at_instants(*system, sweep, instants, between, [&] {
    for (double const eps : system->particles.eps)
      sampled.energies.push_back(eps * K);
    for (auto const& p : system->particles.p)
      sampled.momenta.push_back(p.x * std::sqrt(K));
  });
  sampled.counts = system->pair_counts;
  return sampled;
}

struct Case {
  double K, dt;
  int between;
  By by;
};

class MetropolisScheme : public ::testing::TestWithParam<Case> {};

// The exact laws: eps follows Gamma(C_K/k_B, k_B T), C_K = (3/2)(K-1) k_B (sdpd/README.md, Eq. (S19)),
// momenta Maxwell's.
TEST_P(MetropolisScheme, HasTheExactLawsAtAnyTimeStep) {
  auto const [K, dt, between, by] = GetParam();
  auto const sampled = sample(by, PairScheme::ems, K, dt, 30, between);
  double const shape = 1.5 * (K - 1);
  ASSERT_EQ(sampled.energies.size(), 30u * 11 * 11 * 11);
  EXPECT_LT(std::abs(sampled.width(shape) - 1), 4 * sampled.width_se(shape)) << sampled.width(shape);
  EXPECT_GT(
      cg::kolmogorov_smirnov_p(sampled.energies, [&](double x) { return gsl_cdf_gamma_P(x, shape, 1); }),
      1e-3);
  EXPECT_LT(cg::kolmogorov_smirnov_p(sampled.energies,
                                     [&](double x) { return gsl_cdf_gamma_P(x, shape * 1.1, 1 / 1.1); }),
            1e-3); // a law 10 % too narrow fails
  EXPECT_GT(cg::kolmogorov_smirnov_p(sampled.momenta, [](double x) { return gsl_cdf_ugaussian_P(x); }), 1e-3);
  double const rejected =
      static_cast<double>(sampled.counts.metropolis) / static_cast<double>(sampled.counts.proposed);
  EXPECT_GT(rejected, 0);
  EXPECT_LT(rejected, 0.5);
  RecordProperty("rejected_by_metropolis", std::to_string(rejected));
}

INSTANTIATE_TEST_SUITE_P(Sizes, MetropolisScheme,
                         ::testing::Values(Case{2, 0.3, 20, By::engine}, Case{5, 1, 10, By::engine},
                                           Case{10, 1, 10, By::engine}, Case{50, 1, 20, By::engine},
                                           Case{2, 0.3, 20, By::blocks}, Case{5, 1, 10, By::blocks},
                                           Case{10, 1, 10, By::blocks}),
                         [](auto const& info) {
                           return "K" + std::to_string(int(info.param.K)) +
                                  (info.param.by == By::blocks ? "InBlocks" : "");
                         });

// Refusing only what would leave the equation of state is no Metropolis step: at K = 5, dt = 1 an independent
// code found energies 6.6 % too widely spread.
TEST(SchemeThatRefusesNegativeEnergies, SpreadsTheEnergiesTooWidely) {
  double const shape = 6;
  for (By const by : {By::engine, By::blocks}) {
    auto const ams = sample(by, PairScheme::ams, 5, 1, 30, 10);
    EXPECT_GT(ams.width(shape) - 1, 4 * ams.width_se(shape));
    EXPECT_NEAR(ams.width(shape), 1.066, 0.03);
    double const rejected =
        static_cast<double>(ams.counts.out_of_domain) / static_cast<double>(ams.counts.proposed);
    EXPECT_GT(rejected, 1e-5);
    EXPECT_LT(rejected, 2e-4); // 0.005 ... 0.01 % in the thesis
  }
}

} // namespace
} // namespace mesobridge::sdpd
