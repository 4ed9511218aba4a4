#include "md/error.hpp"
#include "sdpd/neighbours/cells.hpp"
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
  std::set<Index> all;
  for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
    std::set<Index> seen;
    for (std::size_t k = begin[phase]; k < begin[phase + 1]; ++k, ++checked)
      for (Index const cell : grid.blocks()[k].cell) {
        EXPECT_TRUE(seen.insert(cell).second);
        all.insert(cell);
      }
  }
  EXPECT_EQ(checked, grid.blocks().size());
  EXPECT_EQ(all.size(), grid.cell_count());
}

TEST_P(CellGridOf, VisitsEveryImageOfEveryNeighbourOnce) {
  CellGrid const grid(Box{GetParam()}, 1.0);
  std::map<std::tuple<Index, Index, double, double, double>, int> visits;
  for (auto const& block : grid.blocks())
    for (auto const& [a, b] : block.pairs) {
      Vec3 const s = block.shift[b] - block.shift[a];
      ++visits[{block.cell[a], block.cell[b], s.x, s.y, s.z}];
      if (a != b)
        ++visits[{block.cell[b], block.cell[a], -s.x, -s.y, -s.z}];
    }
  for (auto const& [key, count] : visits)
    EXPECT_EQ(count, 1);
  EXPECT_EQ(visits.size(), 27 * grid.cell_count()); // itself and 26 neighbours
}

INSTANTIATE_TEST_SUITE_P(Boxes, CellGridOf,
                         ::testing::Values(Vec3{2.1, 2.1, 2.1}, Vec3{3.5, 3.5, 3.5}, Vec3{4, 5, 6},
                                           Vec3{2, 3, 7.9}, Vec3{9, 11.5, 5.5}, Vec3{7, 10, 13}));

TEST(CellGrid, HasCellsAtLeastAsLongAsTheRange) {
  int checked = 0;
  for (double edge = 2; edge < 40; edge += 0.37, ++checked) {
    CellGrid const grid(Box{{edge, 2, 2}}, 1.0);
    EXPECT_LE(static_cast<double>(grid.cell_count() / 4), edge) << edge;
    EXPECT_EQ(grid.phase_count(), 8u) << edge;
  }
  EXPECT_GT(checked, 100);
}

TEST(CellGrid, RefusesABoxThatIsTooSmall) {
  EXPECT_THROW(CellGrid(Box{{5, 5, 1.99}}, 1.0), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
