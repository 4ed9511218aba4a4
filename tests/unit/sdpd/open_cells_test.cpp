#include "pair_fluid_fixtures.hpp"
#include "sdpd/neighbours/neighbours.hpp"
#include "sdpd/simulation.hpp"
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

// Along open edges the cells follow the particles, however far they fly, and are no more than there are
// particles.

namespace mesobridge::sdpd {
namespace {

constexpr double range = 1, skin = 0.2;

struct Case {
  std::array<bool, 3> open;
  double flight; ///< how far the fastest have come
};

class OpenCells : public ::testing::TestWithParam<Case> {
 protected:
  /// A drop in a corner of the box of 6 x 5 x 7, and a few that fly away from it, each with a companion.
  static Particles scattered(Box const& box) {
    std::mt19937_64 bits(11);
    std::uniform_real_distribution<double> within(0, 2.5), way(-GetParam().flight, GetParam().flight);
    std::normal_distribution<double> near(0, 0.4);
    Particles particles;
    particles.resize(400, {});
    for (std::size_t i = 0; i < particles.size(); ++i) {
      Vec3& q = particles.q[i] = {within(bits), within(bits), within(bits)};
      if (i >= 300 && i % 2 == 0)
        for (int d = 0; d < 3; ++d)
          component(q, d) += GetParam().open[static_cast<unsigned>(d)] ? way(bits) : 0;
      if (i >= 300 && i % 2 == 1)
        q = particles.q[i - 1] + Vec3{near(bits), near(bits), near(bits)};
      q = box.wrap(q);
      particles.id[i] = static_cast<std::uint32_t>(i);
    }
    return particles;
  }

  Box const box{{6, 5, 7}, {!GetParam().open[0], !GetParam().open[1], !GetParam().open[2]}};
  Particles particles = scattered(box);
  Neighbours neighbours{box, range, skin, 2, GetParam().open};
};

TEST_P(OpenCells, FindEveryPairOnce) {
  neighbours.renew(particles);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> found;
  for (std::size_t block = 0; block < neighbours.grid().blocks().size(); ++block)
    for (auto const& [i, j] : neighbours.candidates(block)) {
      auto const a = particles.id[global_index(neighbours.members(block), i)],
                 b = particles.id[global_index(neighbours.members(block), j)];
      ++found[std::minmax(a, b)];
    }
  std::size_t within = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = i + 1; j < particles.size(); ++j)
      if (norm(box.minimum_image(particles.q[i] - particles.q[j])) < range + skin) {
        ++within;
        EXPECT_EQ((found[std::minmax(particles.id[i], particles.id[j])]), 1) << i << " " << j;
      }
  EXPECT_GT(within, 2000u);
  EXPECT_LT(found.size(), within + within / 50); // single precision may let some in that are hardly farther
  for (auto const& [pair, count] : found)
    EXPECT_EQ(count, 1);
}

TEST_P(OpenCells, AreNoMoreThanParticlesAndShareNoneWithinAPhase) {
  neighbours.renew(particles);
  auto const& grid = neighbours.grid();
  EXPECT_LE(grid.cell_count(), particles.size() + 1);
  EXPECT_LE(grid.blocks().size(), 14 * particles.size());
  std::size_t checked = 0;
  for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
    std::set<Index> seen;
    for (std::size_t k = grid.phase_begin()[phase]; k < grid.phase_begin()[phase + 1]; ++k)
      for (auto const& cell : neighbours.members(k))
        for (Index i = cell.begin; i < cell.end; ++i, ++checked)
          EXPECT_TRUE(seen.insert(i).second) << phase;
  }
  EXPECT_GE(checked, particles.size());
}

// The same positions give the same lists, whatever was there before: a restart needs it.
TEST_P(OpenCells, DependOnThePositionsAlone) {
  neighbours.renew(particles);
  auto const order = particles.id;
  auto const blocks = neighbours.grid().blocks().size();
  auto there = particles;
  for (auto& q : particles.q)
    if (GetParam().open[2])
      q.z *= -3;
  neighbours.renew(particles);
  neighbours.renew(there);
  EXPECT_EQ(there.id, order);
  EXPECT_EQ(neighbours.grid().blocks().size(), blocks);
}

// A fluid far outside the box feels what it felt inside it, to the digits that positions have there.
TEST(FarFluid, HasTheForcesOfTheSameFluidInTheBox) {
  auto settings = dpde_fluid(40, 0.01, 2);
  settings.lattice = {6, 6, 9};
  settings.disorder = 0.2;
  settings.faces[2][0].kind = settings.faces[2][1].kind = FaceKind::open;
  Simulation near(settings), far(settings);
  auto start = near.checkpoint();
  near.begin_from(start);
  for (auto& q : start.particles.q)
    q.z += 1e9;
  far.begin_from(start);
  EXPECT_EQ(near.neighbours(), far.neighbours());
  EXPECT_NEAR(far.observe().energy() / near.observe().energy(), 1, 1e-6);
  near.advance(20), far.advance(20);
  EXPECT_NEAR(far.observe().energy() / near.observe().energy(), 1, 1e-5);
  EXPECT_NEAR(far.neighbours() / near.neighbours(), 1, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Boxes, OpenCells,
                         ::testing::Values(Case{{false, false, true}, 3}, Case{{true, false, false}, 1e3},
                                           Case{{true, true, false}, 1e6}, Case{{true, true, true}, 3e8}));

} // namespace
} // namespace mesobridge::sdpd
