#include "sdpd/cells.hpp"
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace mesobridge::sdpd {
namespace {

class CellGridOf : public ::testing::TestWithParam<Vec3> {};

TEST_P(CellGridOf, SharesNoCellWithinAPhase) {
  CellGrid const grid(Box{GetParam()}, 1.0);
  auto const begin = grid.phase_begin();
  std::size_t checked = 0;
  for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
    std::set<Index> seen;
    for (std::size_t k = begin[phase]; k < begin[phase + 1]; ++k, ++checked) {
      auto const& pair = grid.pairs()[k];
      EXPECT_TRUE(seen.insert(pair.first).second);
      if (pair.second != pair.first) {
        EXPECT_TRUE(seen.insert(pair.second).second);
      }
    }
  }
  EXPECT_EQ(checked, 14 * grid.cell_count());
}

TEST_P(CellGridOf, VisitsEveryImageOfEveryNeighbourOnce) {
  CellGrid const grid(Box{GetParam()}, 1.0);
  std::map<std::tuple<Index, Index, double, double, double>, int> visits;
  for (auto const& [a, b, s] : grid.pairs()) {
    ++visits[{a, b, s.x, s.y, s.z}];
    if (a != b)
      ++visits[{b, a, -s.x, -s.y, -s.z}];
  }
  for (auto const& [key, count] : visits)
    EXPECT_EQ(count, 1);
  EXPECT_EQ(visits.size(), 27 * grid.cell_count()); // itself and 26 neighbours
}

INSTANTIATE_TEST_SUITE_P(Boxes, CellGridOf,
                         ::testing::Values(Vec3{2.1, 2.1, 2.1}, Vec3{3.5, 3.5, 3.5}, Vec3{4, 5, 6},
                                           Vec3{2, 3, 7.9}));

TEST(CellGrid, RefusesABoxThatIsTooSmall) {
  EXPECT_THROW(CellGrid(Box{{5, 5, 1.99}}, 1.0), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
