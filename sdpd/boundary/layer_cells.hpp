#pragma once
#include "md/box.hpp"
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace mesobridge::sdpd {

/// One of the edges of the box along the walls, in cells that are at least as long as the reach; in corners,
/// where there is none to walk along, one cell.
struct LayerEdge {
  int axis;
  double length = 1, half = std::numeric_limits<double>::infinity();
  bool periodic = false;
  int cells = 1;

  explicit LayerEdge(int along) : axis(along) {}
  LayerEdge(Box const& box, int along, double reach)
      : axis(along), length(component(box.edge, along)), periodic(box.periodic[static_cast<unsigned>(along)]),
        cells(std::max(1, static_cast<int>(length / reach))) {
    if (periodic)
      half = 0.5 * length;
  }

  int cell_of(double at) const { return static_cast<int>(std::clamp(at / length * cells, 0.0, cells - 1.0)); }

  /// The shorter one of a way and its periodic images, at most 1.5 lengths long before; for numbers and
  /// lanes.
  template <class X>
  X nearest(X const& way) const {
    return way > half ? way - length : way < -half ? way + length : way;
  }

  /// Calls f for the cell and those beside it, each once.
  template <class F>
  void for_each_around(int cell, F const& f) const {
    bool const all = periodic && cells <= 3;
    int const first = all ? 0 : periodic ? cell - 1 : std::max(0, cell - 1);
    int const last = all ? cells - 1 : periodic ? cell + 1 : std::min(cells - 1, cell + 1);
    for (int at = first; at <= last; ++at)
      f((at + cells) % cells);
  }
};

/// The places of a layer by their cells along two edges, and where they are, cell after cell, in each in
/// their order; with room for whole registers past the end.
class LayerCells {
 public:
  /// positions[d][k]: where place k is, k = 0 ... count-1; `axis_a` and the last one lie along the edges.
  void sort(LayerEdge const& edge_a, LayerEdge const& edge_b,
            std::array<std::vector<double>, 3> const& positions, std::size_t axis_a, std::size_t count,
            std::size_t room) {
    auto const cell_of = [&](std::size_t k) {
      return cell(edge_a, edge_a.cell_of(positions[axis_a][k]), edge_b.cell_of(positions[2][k]));
    };
    begin_.assign(static_cast<std::size_t>(edge_a.cells * edge_b.cells) + 1, 0);
    for (std::size_t k = 0; k < count; ++k)
      ++begin_[cell_of(k) + 1];
    for (std::size_t c = 1; c < begin_.size(); ++c)
      begin_[c] += begin_[c - 1];
    next_.assign(begin_.begin(), begin_.end() - 1);
    places.resize(count + room);
    for (auto& values : at)
      values.resize(count + room);
    for (std::size_t k = 0; k < count; ++k) {
      auto const m = next_[cell_of(k)]++;
      places[m] = static_cast<std::uint32_t>(k);
      for (std::size_t d = 0; d < 3; ++d)
        at[d][m] = positions[d][k];
    }
  }

  /// Calls f(begin, end) for the places of the cells around a point.
  template <class F>
  void for_each_around(LayerEdge const& edge_a, LayerEdge const& edge_b, double a, double b,
                       F const& f) const {
    edge_b.for_each_around(edge_b.cell_of(b), [&](int y) {
      edge_a.for_each_around(edge_a.cell_of(a), [&](int x) {
        auto const c = cell(edge_a, x, y);
        f(begin_[c], begin_[c + 1]);
      });
    });
  }

  std::array<std::vector<double>, 3> at;
  std::vector<std::uint32_t> places;

 private:
  static std::size_t cell(LayerEdge const& edge_a, int x, int y) {
    return static_cast<std::size_t>(y * edge_a.cells + x);
  }

  std::vector<std::size_t> begin_, next_;
};

} // namespace mesobridge::sdpd
