#include "sdpd/neighbours/cells.hpp"
#include "md/error.hpp"
#include "sdpd/neighbours/unit_pairs.hpp"
#include "sdpd/threads/team.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace mesobridge::sdpd {
namespace {

Index cells_along(double edge, double range) {
  return static_cast<Index>(edge / range);
}

Box checked(Box const& box, double range) {
  require_cells(box, range);
  return box;
}

/// Wide stretches fill the lanes of a sweep, because their pairs fall into fewer and longer matchings, and
/// spare copies; beyond two cells the copies outgrow the first cache.
constexpr Index best_width = 2;

/// n cells along an edge in an even number of stretches, so that two colours serve: four or more where that
/// is possible, so that threads have work at the same time.
std::vector<Stretch> stretches(Index n) {
  Index const most = n - n % 2, wanted = 2 * ((n + best_width) / (2 * best_width));
  Index const count = std::clamp<Index>(wanted, std::min<Index>(4, most), most);
  std::vector<Stretch> parts;
  for (Index k = 0, begin = 0; k < count; begin += parts[k++].width)
    parts.push_back({begin, n / count + (k < n % count ? 1 : 0)});
  return parts;
}

/// Calls f(x, y, z) for 0 <= x < n[0] ..., x fastest.
template <class F>
void for_each_place(std::array<Index, 3> const& n, F const& f) {
  for (Index z = 0; z < n[2]; ++z)
    for (Index y = 0; y < n[1]; ++y)
      for (Index x = 0; x < n[0]; ++x)
        f(std::array<Index, 3>{x, y, z});
}

} // namespace

void require_cells(Box const& box, double range) {
  require(range > 0 && std::isfinite(range), "range of the interaction", range,
          "must be > 0 and finite (reduced units)");
  double cells = 1;
  std::array<double, 3> const edges{box.edge.x, box.edge.y, box.edge.z};
  for (unsigned d = 0; d < 3; ++d) {
    double const edge = edges[d], least = (box.periodic[d] ? 2 : 1) * range;
    require(edge >= least && std::isfinite(edge), "box edge", edge,
            fmt::format("must be at least {} the range of the interaction, {:.6g} (kernel support and "
                        "skin, reduced units): take more particles",
                        box.periodic[d] ? "twice" : "as long as", least));
    cells *= std::floor(edge / range) + (box.periodic[d] ? 0 : 1);
  }
  require(cells <= std::numeric_limits<Index>::max(), "cells of the box", cells,
          fmt::format("must be <= {}: its particles are too far apart for the range of their interaction",
                      std::numeric_limits<Index>::max()));
}

CellGrid::CellGrid(Box box, double range, std::array<bool, 3> open)
    : box_(checked(box, range)),
      open_(open), filled_{cells_along(box.edge.x, range), cells_along(box.edge.y, range),
                           cells_along(box.edge.z, range)} {
  for (unsigned d = 0; d < 3; ++d) {
    n_[d] = filled_[d] + (box.periodic[d] ? 0 : 1);
    along_[d] = stretches(n_[d]);
  }
  if (is_endless()) { // cells and blocks come with the particles
    cell_count_ = 1;
    phase_begin_.assign(9, 0);
    return;
  }
  cell_count_ = std::size_t{n_[0]} * n_[1] * n_[2];
  std::array<std::vector<Block>, 8> phases; // even and odd stretches along each edge
  for_each_place({static_cast<Index>(along_[0].size()), static_cast<Index>(along_[1].size()),
                  static_cast<Index>(along_[2].size())},
                 [&](std::array<Index, 3> const& at) {
                   Stretch const x = along_[0][at[0]], y = along_[1][at[1]], z = along_[2][at[2]];
                   phases[at[0] % 2 + 2 * (at[1] % 2) + 4 * (at[2] % 2)].push_back(
                       block_at({x.begin, y.begin, z.begin}, {x.width, y.width, z.width}));
                 });
  for (auto& phase : phases) {
    std::move(phase.begin(), phase.end(), std::back_inserter(blocks_));
    phase_begin_.push_back(blocks_.size());
  }
}

void CellGrid::place(std::span<Vec3 const> q, int threads, std::vector<Index>& cell) {
  cell.resize(q.size());
  if (is_endless())
    return find_occupied(q, threads, cell);
  for_each_index(q.size(), threads, [&](std::size_t i) { cell[i] = cell_of(q[i]); });
}

Index CellGrid::cell_of(Vec3 const& q) const {
  auto along = [](double value, double edge, Index n) {
    return static_cast<Index>(std::clamp(value / edge * n, 0.0, n - 1.0));
  };
  return (along(q.z, box_.edge.z, filled_[2]) * n_[1] + along(q.y, box_.edge.y, filled_[1])) * n_[0] +
         along(q.x, box_.edge.x, filled_[0]);
}

Block CellGrid::block_at(std::array<Index, 3> const& corner, std::array<Index, 3> const& width) {
  std::array<double, 3> const edge{box_.edge.x, box_.edge.y, box_.edge.z};
  Block block;
  for_each_place({width[0] + 1, width[1] + 1, width[2] + 1}, [&](std::array<Index, 3> at) {
    std::array<double, 3> shift{};
    for (unsigned d = 0; d < 3; ++d)
      if ((at[d] += corner[d]) == n_[d]) // leaving through a face means meeting the image on the other side
        at[d] = 0, shift[d] = edge[d];
    block.cell.push_back((at[2] * n_[1] + at[1]) * n_[0] + at[0]);
    block.shift.push_back({shift[0], shift[1], shift[2]});
  });
  block.pairs = pairs_of(width);
  return block;
}

std::span<CellPair const> CellGrid::pairs_of(std::array<Index, 3> const& width) {
  auto& pairs = pairs_[width];
  if (pairs.empty())
    for_each_place(width, [&](std::array<Index, 3> const& at) {
      auto place = [&](unsigned unit) {
        return static_cast<std::uint8_t>(((at[2] + (unit >> 2)) * (width[1] + 1) + at[1] + (unit >> 1 & 1u)) *
                                             (width[0] + 1) +
                                         at[0] + (unit & 1u));
      };
      for (auto const& [a, b] : unit_pairs)
        pairs.push_back({place(a), place(b)});
    });
  return pairs;
}

} // namespace mesobridge::sdpd
