#include "sdpd/cells.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

/// Half of the 26 neighbours: of each pair of opposite offsets the one that is lexicographically positive.
constexpr std::array<std::array<int, 3>, 13> half_stencil{{{1, 0, 0},
                                                           {1, 1, 0},
                                                           {0, 1, 0},
                                                           {-1, 1, 0},
                                                           {1, 0, 1},
                                                           {1, 1, 1},
                                                           {0, 1, 1},
                                                           {-1, 1, 1},
                                                           {-1, 0, 1},
                                                           {-1, -1, 1},
                                                           {0, -1, 1},
                                                           {1, -1, 1},
                                                           {0, 0, 1}}};

Index cells_along(double edge, double range) {
  require(edge >= 2 * range, "box edge", edge,
          fmt::format("must be at least twice the range of the interaction, {:.6g} (kernel support and skin, "
                      "reduced units): take more particles",
                      2 * range));
  return static_cast<Index>(edge / range);
}

} // namespace

CellGrid::CellGrid(Box box, double range)
    : box_(box), n_{cells_along(box.edge.x, range), cells_along(box.edge.y, range),
                    cells_along(box.edge.z, range)} {
  for (Index cell = 0; cell < cell_count(); ++cell)
    pairs_.push_back({cell, cell, {}});
  phase_begin_.push_back(pairs_.size());
  for (auto const& offset : half_stencil)
    colour(offset);
}

Index CellGrid::cell_of(Vec3 const& q) const {
  auto along = [](double value, double edge, Index n) {
    return std::min(static_cast<Index>(value / edge * n), n - 1);
  };
  return (along(q.z, box_.edge.z, n_[2]) * n_[1] + along(q.y, box_.edge.y, n_[1])) * n_[0] +
         along(q.x, box_.edge.x, n_[0]);
}

CellPair CellGrid::neighbour(Index cell, std::array<int, 3> const& offset) const {
  std::array<Index, 3> const at{cell % n_[0], cell / n_[0] % n_[1], cell / n_[0] / n_[1]};
  std::array<double, 3> const edge{box_.edge.x, box_.edge.y, box_.edge.z};
  std::array<Index, 3> to;
  std::array<double, 3> shift{};
  for (int d = 0; d < 3; ++d) {
    int const moved = static_cast<int>(at[d]) + offset[d], n = static_cast<int>(n_[d]);
    // Leaving through a face means meeting the image on the other side of the box.
    shift[d] = moved < 0 ? -edge[d] : moved >= n ? edge[d] : 0.0;
    to[d] = static_cast<Index>((moved + n) % n);
  }
  return {cell, (to[2] * n_[1] + to[1]) * n_[0] + to[0], {shift[0], shift[1], shift[2]}};
}

void CellGrid::colour(std::array<int, 3> const& offset) {
  // Along one offset every cell belongs to two pairs, so that the pairs form rings: two colours serve an even
  // ring, three an odd one.
  std::array<std::vector<CellPair>, 3> colours;
  std::vector<unsigned> used(cell_count(), 0);
  for (Index cell = 0; cell < cell_count(); ++cell) {
    CellPair const pair = neighbour(cell, offset);
    unsigned const taken = used[pair.first] | used[pair.second];
    int const c = !(taken & 1u) ? 0 : !(taken & 2u) ? 1 : 2;
    used[pair.first] |= 1u << c, used[pair.second] |= 1u << c;
    colours[c].push_back(pair);
  }
  for (auto const& members : colours)
    if (!members.empty()) {
      pairs_.insert(pairs_.end(), members.begin(), members.end());
      phase_begin_.push_back(pairs_.size());
    }
}

} // namespace mesobridge::sdpd
