#pragma once
#include "md/box.hpp"
#include "sdpd/state/particles.hpp"
#include <array>
#include <cstdint>
#include <map>
#include <span>

namespace mesobridge::sdpd {

/// Two cells of a block, by their places in it; the first may be the second.
struct CellPair {
  std::uint8_t a, b;
};

/// Some cells that hang together, two or three along each edge. `shift` brings a particle of a cell to the
/// periodic image that is next to the others.
struct Block {
  std::vector<Index> cell;
  std::vector<Vec3> shift;
  std::span<CellPair const> pairs; ///< the pairs of its cells that belong to it
};

/// A stretch of cells along an edge begins at `begin` and owns the `width` gaps that follow: it holds
/// width + 1 cells.
struct Stretch {
  Index begin, width;
};

/// A grid of cells whose edges are at least the range of the interaction. Along an edge that ends at walls
/// a layer of cells without particles ends it, across which there are no neighbours, and the outermost cells
/// hold all that lies beyond the walls. Along open edges the grid goes on without end; where there are some,
/// only cells that hold particles are kept, so that neither empty room nor what flies far costs anything.
/// The cells are covered by blocks
/// that overlap by one cell; together the blocks hold every pair of touching cells once. Blocks come in
/// phases: within one phase no two blocks share a cell, so that threads may treat them at the same time, and
/// the result of a sweep depends on the order of the phases alone, not on the number of threads.
class CellGrid {
 public:
  /// Throws InputError when an edge of the box is shorter than twice the range, or once if not periodic.
  CellGrid(Box box, double range, std::array<bool, 3> open = {});
  CellGrid(CellGrid&&) noexcept = default; // its blocks refer to its pairs
  CellGrid& operator=(CellGrid&&) noexcept = default;

  std::size_t cell_count() const { return cell_count_; }
  /// The cell of each of some finite positions. Along open edges cells and blocks are made anew for them.
  void place(std::span<Vec3 const> q_wrapped, int threads, std::vector<Index>& cell);

  /// The blocks, phase after phase.
  std::span<Block const> blocks() const { return blocks_; }
  /// Phase k holds the blocks phase_begin()[k] ... phase_begin()[k+1]-1.
  std::span<std::size_t const> phase_begin() const { return phase_begin_; }
  std::size_t phase_count() const { return phase_begin_.size() - 1; }

 private:
  /// Along z, y, x: where a cell is, and which stretches a block is made of.
  using Place = std::array<std::int64_t, 3>;

  bool is_endless() const { return open_[0] || open_[1] || open_[2]; }
  Index cell_of(Vec3 const& q) const;
  Place place_of(Vec3 const& q) const;
  /// The stretch along one edge that owns the gap behind a cell.
  std::int64_t stretch_of(unsigned axis, std::int64_t cell) const;
  void find_occupied(std::span<Vec3 const> q, int threads, std::vector<Index>& cell);
  void cover_occupied();
  /// number(place): that of a cell, or that of the cell for all empty ones.
  template <class Number>
  Block block_of(Place const& stretches, Number const& number);
  Block block_at(std::array<Index, 3> const& corner, std::array<Index, 3> const& width);
  std::span<CellPair const> pairs_of(std::array<Index, 3> const& width);

  Box box_;
  std::array<bool, 3> open_;
  std::array<Index, 3> filled_; ///< cells along each edge of the box that hold particles
  std::array<Index, 3> n_;
  std::array<std::vector<Stretch>, 3> along_;
  std::size_t cell_count_;
  std::vector<Place> occupied_;                                 ///< with open edges: the cells, in order
  std::map<std::array<Index, 3>, std::vector<CellPair>> pairs_; ///< by the widths of a block
  std::vector<Block> blocks_;
  std::vector<std::size_t> phase_begin_{0};
};

/// Throws InputError when an edge of the box is shorter than twice the range, or once if it is not periodic,
/// or when there are more cells of that range in it than can be counted.
void require_cells(Box const& box, double range);

} // namespace mesobridge::sdpd
