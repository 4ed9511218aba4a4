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

/// From a cell to itself and one of each two opposite neighbours.
constexpr std::array<std::array<std::int64_t, 3>, 14> half_of_ways{{{0, 0, 0},
                                                                    {0, 0, 1},
                                                                    {0, 1, -1},
                                                                    {0, 1, 0},
                                                                    {0, 1, 1},
                                                                    {1, -1, -1},
                                                                    {1, -1, 0},
                                                                    {1, -1, 1},
                                                                    {1, 0, -1},
                                                                    {1, 0, 0},
                                                                    {1, 0, 1},
                                                                    {1, 1, -1},
                                                                    {1, 1, 0},
                                                                    {1, 1, 1}}};

std::int64_t half(std::int64_t cell) { // rounded down
  return (cell - (cell & 1)) / width;
}

/// The numbers of some cells, given in order: from a table of the room that they take up, unless most of that
/// is empty.
class CellNumbers {
 public:
  using Place = std::array<std::int64_t, 3>;

  explicit CellNumbers(std::vector<Place> const& cells) : cells_(cells) {
    constexpr double most_per_cell = 32; // room of the table
    if (cells.empty())
      return;
    for (unsigned d = 0; d < 3; ++d) {
      auto const [lowest, highest] = std::ranges::minmax(cells, {}, [d](Place const& at) { return at[d]; });
      lowest_[d] = lowest[d], highest_[d] = highest[d];
    }
    double room = 1;
    for (unsigned d = 0; d < 3; ++d)
      room *= static_cast<double>(highest_[d]) - static_cast<double>(lowest_[d]) + 1;
    if (room > most_per_cell * static_cast<double>(cells.size()))
      return;
    table_.assign(static_cast<std::size_t>(room), static_cast<Index>(cells.size()));
    for (std::size_t k = 0; k < cells.size(); ++k)
      table_[in_table(cells[k])] = static_cast<Index>(k);
  }

  /// How many there are, for one that is not among them.
  Index operator()(Place const& place) const {
    if (table_.empty()) {
      auto const found = std::ranges::lower_bound(cells_, place);
      bool const is_there = found != cells_.end() && *found == place;
      return static_cast<Index>(is_there ? found - cells_.begin() : std::ssize(cells_));
    }
    for (unsigned d = 0; d < 3; ++d)
      if (place[d] < lowest_[d] || place[d] > highest_[d])
        return static_cast<Index>(cells_.size());
    return table_[in_table(place)];
  }

 private:
  std::size_t in_table(Place const& place) const {
    std::int64_t at = 0;
    for (unsigned d = 0; d < 3; ++d)
      at = at * (highest_[d] - lowest_[d] + 1) + place[d] - lowest_[d];
    return static_cast<std::size_t>(at);
  }

  std::vector<Place> const& cells_;
  Place lowest_{}, highest_{};
  std::vector<Index> table_; ///< empty where the cells are too far apart
};

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

std::int64_t CellGrid::stretch_of(unsigned axis, std::int64_t cell) const {
  if (!box_.periodic[axis])
    return half(cell);
  auto const& along = along_[axis];
  return std::ranges::upper_bound(along, static_cast<Index>(cell), {}, &Stretch::begin) - along.begin() - 1;
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
  CellNumbers const number(occupied_);
  for_each_part(q.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      cell[i] = i > begin && places[i] == places[i - 1] ? cell[i - 1] : number(places[i]);
  });
}

/// Blocks to which a pair of touching cells that hold particles belongs, or a cell with itself. A pair
/// belongs to the stretches that own the lower of its two places along each edge.
void CellGrid::cover_occupied() {
  std::array<std::vector<Place>, 8> phases; // even and odd stretches along each edge
  CellNumbers const number(occupied_);
  auto const wrapped = [&](Place place) {
    for (unsigned d = 0; d < 3; ++d)
      if (auto& at = place[2 - d]; box_.periodic[d])
        at = at < 0 ? at + n_[d] : at >= n_[d] ? at - n_[d] : at;
    return place;
  };
  for (auto const& place : occupied_)
    for (auto const& way : half_of_ways) {
      auto const [z, y, x] = place;
      bool const itself = way == Place{};
      if (!itself && number(wrapped({z + way[0], y + way[1], x + way[2]})) == occupied_.size())
        continue;
      auto const lower =
          wrapped({z + std::min<std::int64_t>(way[0], 0), y + std::min<std::int64_t>(way[1], 0),
                   x + std::min<std::int64_t>(way[2], 0)});
      Place const owner{stretch_of(2, lower[0]), stretch_of(1, lower[1]), stretch_of(0, lower[2])};
      auto& phase = phases[static_cast<unsigned>((owner[2] & 1) + 2 * (owner[1] & 1) + 4 * (owner[0] & 1))];
      if (phase.empty() || phase.back() != owner) // cells of a stretch mostly follow each other
        phase.push_back(owner);
    }
  cell_count_ = occupied_.size() + 1; // the last stands for all empty ones
  blocks_.clear(), phase_begin_.assign(1, 0);
  for (auto& stretches : phases) {
    std::ranges::sort(stretches);
    stretches.erase(std::unique(stretches.begin(), stretches.end()), stretches.end());
    for (auto const& of_block : stretches)
      blocks_.push_back(block_of(of_block, number));
    phase_begin_.push_back(blocks_.size());
  }
}

template <class Number>
Block CellGrid::block_of(Place const& stretches, Number const& number) {
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
        block.cell.push_back(number(at)), block.shift.push_back(shift);
      }
  block.pairs = pairs_of(widths);
  return block;
}

} // namespace mesobridge::sdpd
