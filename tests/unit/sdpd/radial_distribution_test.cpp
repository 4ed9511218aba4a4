#include "md/error.hpp"
#include "sdpd/observe/radial_distribution.hpp"
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace mesobridge::sdpd {
namespace {

TEST(RadialDistribution, OfRandomPointsIsOne) {
  Box const box{{5, 6, 7}};
  RadialDistribution distribution(box, 2.5, 10);
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> uniform;
  for (int instant = 0; instant < 10; ++instant) {
    std::vector<Vec3> q(400);
    for (auto& each : q)
      each = {5 * uniform(generator), 6 * uniform(generator), 7 * uniform(generator)};
    distribution.add(q);
  }
  auto const g = distribution.g();
  ASSERT_EQ(g.size(), 10u);
  for (std::size_t bin = 3; bin < 10; ++bin) // 2000 pairs or more in a bin
    EXPECT_NEAR(g[bin], 1, 0.06) << "r = " << distribution.centre(bin);
}

TEST(RadialDistribution, CountsTheShellsOfALattice) {
  std::vector<Vec3> q;
  for (int k = 0; k < 216; ++k)
    q.push_back({double(k % 6), double(k / 6 % 6), double(k / 36)});
  RadialDistribution distribution(Box{{6, 6, 6}}, 2.5, 25);
  distribution.add(q);
  EXPECT_DOUBLE_EQ(distribution.neighbours_within(0.9), 0);
  EXPECT_DOUBLE_EQ(distribution.neighbours_within(1.2), 6);
  EXPECT_DOUBLE_EQ(distribution.neighbours_within(1.6), 18);
  EXPECT_DOUBLE_EQ(distribution.neighbours_within(1.9), 26);
  EXPECT_THROW(RadialDistribution(Box{{6, 6, 6}}, 3.5, 10), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
