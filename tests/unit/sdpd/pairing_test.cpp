#include "sdpd/method/settings.hpp"
#include "sdpd/observe/pairing.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>
#include <set>

namespace mesobridge::sdpd {
namespace {

double by_all_pairs(Snapshot const& now, Box const& box, double near) {
  std::set<std::size_t> paired;
  for (std::size_t i = 0; i < now.q.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (norm(box.minimum_image(now.q[i] - now.q[j])) < near)
        paired.insert({i, j});
  return static_cast<double>(paired.size()) / static_cast<double>(now.q.size());
}

TEST(Pairing, IsThatOfADirectCountAtEveryDisorder) {
  auto settings = argon(10, 0.03);
  settings.lattice = {8, 9, 10};
  int cases = 0;
  double before = -1;
  for (double const disorder : {0.0, 0.2, 0.3, 0.5}) {
    settings.disorder = disorder;
    Simulation const simulation(settings);
    double const fraction = simulation.pairing_fraction();
    EXPECT_DOUBLE_EQ(fraction, by_all_pairs(simulation.snapshot(), simulation.box(), 0.35)) << disorder;
    EXPECT_GT(fraction, before);
    before = fraction, ++cases;
  }
  EXPECT_EQ(cases, 4);
  EXPECT_NEAR(before, 0.16, 0.05); // nearly a random gas: 1 - exp(-4 pi 0.35^3 / 3)
}

TEST(Pairing, CountsTheDistanceInMeanSpacings) {
  Simulation const simulation(
      {.method = Dpd{{.mass = 1, .potential = SoftPotential(1, 1), .friction = PowerFriction(1, 0, 1, 2)}},
       .rho = 24,
       .T = 1,
       .lattice = {9, 9, 9},
       .disorder = 0.3,
       .dt = 0.01});
  double const spacing = std::cbrt(1.0 / 24);
  EXPECT_DOUBLE_EQ(simulation.pairing_fraction(),
                   by_all_pairs(simulation.snapshot(), simulation.box(), 0.35 * spacing));
  EXPECT_GT(simulation.pairing_fraction(), 0.01);
  EXPECT_LT(simulation.pairing_fraction(), 0.3);
}

// What it is for: 65 neighbours of the cubic kernel pair within a hundred reduced times, Wendland's do not.
TEST(Pairing, GrowsWithTheCubicKernelAndNotWithWendlands) {
  int cases = 0;
  for (auto const& [kernel, least, most] : {std::tuple("cubic", 0.05, 1.0), {"wendland-c4", 0.0, 0.005}}) {
    auto settings = argon(1000, 0.1);
    settings.as<Sdpd>().kernel = kernel;
    settings.lattice = {7, 7, 7};
    settings.disorder = 0.15;
    Simulation simulation(settings);
    simulation.advance(1000);
    EXPECT_GE(simulation.pairing_fraction(), least) << kernel;
    EXPECT_LE(simulation.pairing_fraction(), most) << kernel;
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

} // namespace
} // namespace mesobridge::sdpd
