#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/fluctuating_block.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/neighbours/select_pairs.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd_fixtures.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace mesobridge::sdpd {
namespace {

/// Half of the particles anywhere, the others just inside or outside the range of a partner.
Particles pairs_at_range(Box const& box, std::size_t n, double range) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(0, 1);
  Particles particles;
  particles.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    particles.id[i] = static_cast<std::uint32_t>(i);
    if (i % 2 == 0)
      particles.q[i] = {u(random) * box.edge.x, u(random) * box.edge.y, u(random) * box.edge.z};
    else {
      Vec3 const e{u(random) - 0.5, u(random) - 0.5, u(random) - 0.5};
      particles.q[i] = particles.q[i - 1] + (1 + 3e-6 * (u(random) - 0.5)) * range / norm(e) * e;
    }
  }
  return particles;
}

/// A block's pairs, matching after matching.
std::vector<std::vector<std::pair<int, int>>> matchings(Neighbours& neighbours, std::size_t block) {
  std::vector<std::vector<std::pair<int, int>>> result;
  auto const pairs = neighbours.pairs(block);
  std::size_t k = 0;
  for (auto const end : std::as_const(neighbours).pair_ends(block)) {
    result.emplace_back();
    for (; k < end; ++k)
      result.back().emplace_back(pairs[k].i, pairs[k].j);
  }
  EXPECT_EQ(k, pairs.size());
  return result;
}

TEST(SelectPairs, FindsTheSameMatchingsInSingleAndDoublePrecision) {
  Box const box{{80000, 120, 120}}; // places far from the origin cost no digits
  double const range = 40;
  auto particles = pairs_at_range(box, 60000, range);
  Neighbours neighbours(box, range, 10, 1);
  neighbours.renew(particles);
  SelectionScratch scratch;
  std::vector<Row> rows;
  std::vector<FloatRow> float_rows;
  std::size_t pairs = 0, more = 0;
  auto nothing = [](Index) { return 0.0; };
  for (std::size_t block = 0; block < neighbours.grid().blocks().size(); ++block) {
    copy_rows(neighbours.members(block), particles.q, nothing, 2 * range, rows);
    copy_rows(neighbours.members(block), particles.q, nothing, 2 * range, float_rows);
    select_pairs_and_distances(neighbours, block, rows, scratch);
    auto const exact = matchings(neighbours, block);
    select_pairs(neighbours, block, float_rows, scratch);
    auto const single = matchings(neighbours, block);
    ASSERT_EQ(exact.size(), single.size());
    for (std::size_t m = 0; m < exact.size(); ++m) {
      EXPECT_TRUE(std::ranges::includes(std::set(single[m].begin(), single[m].end()),
                                        std::set(exact[m].begin(), exact[m].end())));
      pairs += exact[m].size(), more += single[m].size() - exact[m].size();
    }
  }
  EXPECT_GT(pairs, 100000u);
  EXPECT_GT(more, 5000u) << "partners just outside";
  EXPECT_LT(more, 30000u) << "no others";
}

/// Neighbours next to the range, on both sides of it in single precision.
TEST(PreparePairs, GivesSomeWeightBesideTheRange) {
  int looked_at = 0, least = 0;
  for (char const* kernel : {"cubic", "lucy", "wendland-c2", "wendland-c4", "wendland-c6"}) {
    auto settings = ideal_gas(100, 0.01);
    settings.as<Sdpd>().kernel = kernel;
    auto const system = make_system(settings);
    auto& q = system->particles.q;
    double const range = system->neighbours.range();
    for (std::size_t i = 1; i < 200; ++i) // around the first; double precision has them in range
      q[i] = q[0] + (1 - 1e-9 * double(i)) * range *
                        Vec3{std::cos(double(i)), std::sin(double(i)) * 0.6, std::sin(double(i)) * 0.8};
    system->neighbours.renew(system->particles);
    find_pairs_and_densities(*system);
    system->energy_gain.assign(system->size(), 0);
    PairInputs inputs;
    FluctuatingBlock block;
    for (std::size_t number = 0; number < system->neighbours.grid().blocks().size(); ++number) {
      auto const pairs = system->neighbours.pairs(number);
      block.copy_in(*system, number);
      prepare_pairs(*system, std::get<SdpdLaw>(system->law), block, pairs,
                    NoiseSource(1, Stream::fluctuation, 0), inputs);
      for (std::size_t k = 0; k < pairs.size(); ++k, ++looked_at) {
        EXPECT_GT(inputs.weight[k], 0);
        least += inputs.weight[k] == 1e-30f;
      }
    }
  }
  EXPECT_GT(looked_at, 5 * 5000);
  EXPECT_GT(least, 0) << "some lie beyond it in single precision";
}

} // namespace
} // namespace mesobridge::sdpd
