#include "md/star_melt.hpp"
#include "md/star_polymer.hpp"
#include "md/star_system.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::md::test {
namespace {

TEST(StarPolymer, StartsWithoutOverlapsForEveryStarThatIsAllowed) {
  int stars = 0;
  double nearest = 10;
  for (int arms = 1; arms <= 12; ++arms)
    for (int beads = 1; beads <= 24; ++beads, ++stars) {
      StarPolymer const star{.arms = arms, .beads = beads};
      auto const atoms = straight_star(star);
      ASSERT_EQ(int(atoms.size()), star.atoms());
      double widest = 0;
      for (std::size_t a = 0; a < atoms.size(); ++a) {
        widest = std::max(widest, norm(atoms[a]));
        for (std::size_t b = a + 1; b < atoms.size(); ++b)
          nearest = std::min(nearest, norm(atoms[a] - atoms[b]));
      }
      EXPECT_NEAR(widest, straight_radius(star), 1e-12);
    }
  EXPECT_EQ(stars, 288);
  EXPECT_GT(nearest, wca_cutoff()) << "no two beads repel each other";
}

TEST(StarPolymer, BondsAreThoseOfTheThesis) {
  StarPolymer const star{.arms = 6, .beads = 3};
  auto const bonds = star.bonds();
  ASSERT_EQ(bonds.size(), 18u);
  EXPECT_EQ(star.atoms(), 19);
  int at_centre = 0;
  std::vector<int> reached(19, 0);
  for (auto const& bond : bonds) {
    EXPECT_EQ(bond.k, 20);
    EXPECT_EQ(bond.l, bond.a == 0 ? 1.615 : 1.147);
    at_centre += bond.a == 0;
    ++reached[std::size_t(bond.b)];
  }
  EXPECT_EQ(at_centre, 6);
  EXPECT_EQ(reached[0], 0);
  EXPECT_EQ(std::count(reached.begin(), reached.end(), 1), 18) << "every bead hangs on one bond";
}

TEST(StarPolymer, TurningKeepsDistancesAndTurnsAllWays) {
  auto const straight = straight_star({});
  Vec3 mean;
  int turns = 0;
  for (int k = 0; k < 512; ++k, ++turns) { // a grid of rotations
    auto const atoms = turned(straight, (k % 8 + 0.5) / 8, (k / 8 % 8 + 0.5) / 8, (k / 64 + 0.5) / 8);
    EXPECT_NEAR(norm(atoms[3]), norm(straight[3]), 1e-12);
    EXPECT_NEAR(dot(atoms[3], atoms[9]), dot(straight[3], straight[9]), 1e-12);
    mean += atoms[3] / norm(atoms[3]);
  }
  EXPECT_LT(norm(mean) / turns, 1e-12) << "no direction is preferred";
}

TEST(StarPolymer, NamesAreReadOrRefused) {
  EXPECT_EQ(star_of_name("6-12"), (StarPolymer{.arms = 6, .beads = 12}));
  int refused = 0;
  for (char const* name : {"", "6", "6-", "-3", "6-3x", "0-3", "13-3", "6-25", "6 3", "six-three"}) {
    EXPECT_THROW(star_of_name(name), InputError) << name;
    ++refused;
  }
  EXPECT_EQ(refused, 10);
}

TEST(StarMelt, ThePlanReachesTheDensityStepByStep) {
  StarMeltSettings const settings{.molecules = 216, .rho = 0.3};
  auto const stretches = plan(settings);
  double rho = 19 / std::pow(touching_free_spacing(settings.star), 3);
  std::int64_t step = 0;
  int squeezes = 0;
  for (auto const& stretch : stretches) {
    EXPECT_EQ(stretch.first_step, step);
    step += stretch.steps;
    if (stretch.phase == MeltPhase::squeeze) {
      EXPECT_GT(stretch.rho, rho);
      EXPECT_LE(stretch.rho, rho * settings.squeeze * (1 + 1e-12));
      rho = stretch.rho;
      ++squeezes;
    }
  }
  EXPECT_GE(squeezes, 5);
  EXPECT_EQ(rho, 0.3);
  EXPECT_EQ(step, squeezes * settings.squeeze_steps + settings.equilibration_steps + settings.sampling_steps);
}

TEST(StarMelt, RefusesWhatMakesNoSense) {
  auto const refused = [](auto change) {
    StarMeltSettings settings;
    change(settings);
    EXPECT_THROW(check(settings), InputError);
    return 1;
  };
  int cases = 0;
  cases += refused([](auto& s) { s.rho = 0; });
  cases += refused([](auto& s) { s.rho = 0.9; });
  cases += refused([](auto& s) { s.T = std::nan(""); });
  cases += refused([](auto& s) { s.dt = -0.001; });
  cases += refused([](auto& s) { s.molecules = 1; });
  cases += refused([](auto& s) { s.checkpoint_every = 150; });
  cases += refused([](auto& s) { s.molecules = 8, s.rho = 0.5, s.star.beads = 12; });
  EXPECT_EQ(cases, 7);
}

} // namespace
} // namespace mesobridge::md::test
