#include "workflows/coarse/potential_search.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

/// A soft fluid: u = a/2 (1 - r)^2 for r < 1.
cg::PairPotential soft(double a, double width) {
  cg::PairPotential potential{width, {}};
  for (int k = 0; (k + 0.5) * width < 1; ++k)
    potential.u.push_back(0.5 * a * std::pow(1 - potential.r(std::size_t(k)), 2));
  return potential;
}

PotentialSearch of_soft_fluid() {
  return {.inversion = {.kT = 1, .cutoff = 1, .share = 1, .knots = 0.1, .density = 3},
          .iterations = 6,
          .settle = 500,
          .sample = 6000,
          .every = 40};
}

TEST(PotentialSearch, FindsASoftPotentialThatWasPutIn) {
  constexpr double a = 25, width = 0.025;
  auto const known = soft(a, width);
  CoarseStructure structure{.density = 3, .mass = 1, .kT = 1, .g = {width, std::vector<double>(136)}};
  PotentialSearch search = of_soft_fluid();
  auto const of_known = try_potential(known, structure, search);
  structure.g = of_known.g;
  search.seed = 2;
  auto const trials = search_potential(structure, search, [](int) {});
  auto const& found = best(trials);
  EXPECT_LE(trials.size(), 6u);
  EXPECT_GT(trials.front().difference, 1e-4); // the potential of mean force is another one
  EXPECT_LT(found.difference, 2e-5);
  double const u_0 = 0.5 * a, worst_at_first = std::abs(trials.front().potential.u[20] - known.u[20]);
  EXPECT_GT(worst_at_first, 0.03 * u_0);
  std::size_t compared = 0;
  for (std::size_t k = 10; k < known.u.size(); ++k, ++compared) // nearer pairs are rare
    EXPECT_NEAR(found.potential.u[k], known.u[k], 0.01 * u_0) << known.r(k);
  EXPECT_EQ(compared, 30u);
  EXPECT_NEAR(found.P.mean / of_known.P.mean, 1,
              0.05); // by a tail that g hardly feels; 1 to 3 % were seen, 77 % at first
}

} // namespace
} // namespace mesobridge::workflows
