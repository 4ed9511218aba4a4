#include "sdpd/neighbours/cells.hpp"
#include "sdpd/threads/team.hpp"
#include <algorithm>
#include <cmath>

// A grid with open edges: cells without end, of which only those that hold particles are kept. Which there
// are, their order and their blocks depend on the positions alone.

namespace mesobridge::sdpd {
namespace {

/// Cells along a stretch that is not one of the box.
constexpr std::int64_t width = 2;

/// Beyond it the numbers of cells are no whole numbers any more, and nothing has neighbours.
constexpr double furthest = 1e15;

double edge_along(Box const& box, unsigned axis) {
  return component(box.edge, static_cast<int>(axis));
}

std::int64_t half(std::int64_t cell) { // rounded down
  return (cell - (cell & 1)) / width;
}

} // namespace

CellGrid::Place CellGrid::place_of(Vec3 const& q) const {
  Place place{};
  for (unsigned d = 0; d < 3; ++d) {
    double const at = std::floor(component(q, static_cast<int>(d)) / edge_along(box_, d) * filled_[d]);
    place[2 - d] = static_cast<std::int64_t>(open_[d] ? std::clamp(at, -furthest, furthest)
                                                      : std::clamp(at, 0.0, filled_[d] - 1.0));
  }
  return place;
}

std::array<std::int64_t, 2> CellGrid::stretches_of(unsigned axis, std::int64_t cell) const {
  if (!box_.periodic[axis])
    return {half(cell), half(cell - 1)};
  auto const& along = along_[axis];
  auto const after = std::ranges::upper_bound(along, static_cast<Index>(cell), {}, &Stretch::begin);
  auto const number = after - along.begin() - 1, count = static_cast<std::ptrdiff_t>(along.size());
  bool const first = cell == along[static_cast<std::size_t>(number)].begin;
  return {number, first ? (number + count - 1) % count : number};
}

Index CellGrid::occupied(Place const& place) const {
  auto const found = std::ranges::lower_bound(occupied_, place);
  bool const is_there = found != occupied_.end() && *found == place;
  return static_cast<Index>(is_there ? found - occupied_.begin() : std::ssize(occupied_));
}

void CellGrid::find_occupied(std::span<Vec3 const> q, int threads, std::vector<Index>& cell) {
  std::vector<Place> places(q.size()), different;
  for_each_index(q.size(), threads, [&](std::size_t i) { places[i] = place_of(q[i]); });
  std::ranges::unique_copy(places,
                           std::back_inserter(different)); // particles of a cell mostly follow each other
  std::ranges::sort(different);
  different.erase(std::unique(different.begin(), different.end()), different.end());
  if (different != occupied_) {
    occupied_ = std::move(different);
    cover_occupied();
  }
  for_each_part(q.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cell[i] = i > begin && places[i] == places[i - 1] ? cell[i - 1] : occupied(places[i]);
  });
}

/// Blocks of all stretches that hold an occupied cell.
void CellGrid::cover_occupied() {
  std::array<std::vector<Place>, 8> phases; // even and odd stretches along each edge
  for (auto const& [z, y, x] : occupied_)
    for (auto const a : stretches_of(2, z))
      for (auto const b : stretches_of(1, y))
        for (auto const c : stretches_of(0, x))
          phases[static_cast<unsigned>((c & 1) + 2 * (b & 1) + 4 * (a & 1))].push_back({a, b, c});
  cell_count_ = occupied_.size() + 1; // the last stands for all empty ones
  blocks_.clear(), phase_begin_.assign(1, 0);
  for (auto& stretches : phases) {
    std::ranges::sort(stretches);
    stretches.erase(std::unique(stretches.begin(), stretches.end()), stretches.end());
    for (auto const& of_block : stretches)
      blocks_.push_back(block_of(of_block));
    phase_begin_.push_back(blocks_.size());
  }
}

Block CellGrid::block_of(Place const& stretches) {
  Place begin{};
  std::array<Index, 3> widths{}; // along x, y, z
  for (unsigned d = 0; d < 3; ++d) {
    auto const stretch = stretches[2 - d];
    bool const of_box = box_.periodic[d];
    begin[2 - d] = of_box ? along_[d][static_cast<std::size_t>(stretch)].begin : width * stretch;
    widths[d] = of_box ? along_[d][static_cast<std::size_t>(stretch)].width : width;
  }
  Block block;
  for (Index z = 0; z <= widths[2]; ++z)
    for (Index y = 0; y <= widths[1]; ++y)
      for (Index x = 0; x <= widths[0]; ++x) {
        Place at{begin[0] + z, begin[1] + y, begin[2] + x};
        Vec3 shift;
        for (unsigned d = 0; d < 3; ++d)
          if (box_.periodic[d] && at[2 - d] == n_[d]) // the image on the other side
            at[2 - d] = 0, component(shift, static_cast<int>(d)) = edge_along(box_, d);
        block.cell.push_back(occupied(at)), block.shift.push_back(shift);
      }
  block.pairs = pairs_of(widths);
  return block;
}

} // namespace mesobridge::sdpd
