#pragma once
#include "md/box.hpp"
#include "sdpd/particles.hpp"
#include <array>
#include <span>

namespace mesobridge::sdpd {

/// Eight cells that meet in a corner. `shift` brings a particle of a cell to the periodic image that hangs
/// together with the others.
struct Block {
  std::array<Index, 8> cell;
  std::array<Vec3, 8> shift;
};

/// The fourteen pairs of a block's cells that belong to it: the first cell with itself and the thirteen pairs
/// of touching cells that no other block holds.
inline constexpr std::array<std::array<int, 2>, 14> block_cell_pairs{{{0, 0},
                                                                      {0, 1},
                                                                      {0, 2},
                                                                      {0, 3},
                                                                      {0, 4},
                                                                      {0, 5},
                                                                      {0, 6},
                                                                      {0, 7},
                                                                      {1, 2},
                                                                      {1, 4},
                                                                      {2, 4},
                                                                      {1, 6},
                                                                      {2, 5},
                                                                      {3, 4}}};

/// A grid of cells whose edges are at least the range of the interaction. Each corner of the grid has a block
/// of eight cells; together the blocks hold every pair of touching cells once. Blocks come in phases: within
/// one phase no two blocks share a cell, so that threads may treat them at the same time, and the result of
/// a sweep depends on the order of the phases alone, not on the number of threads.
class CellGrid {
 public:
  /// Throws InputError when an edge of the box is shorter than twice the range.
  CellGrid(Box box, double range);

  std::size_t cell_count() const { return std::size_t{n_[0]} * n_[1] * n_[2]; }
  Index cell_of(Vec3 const& q_wrapped) const;

  /// The blocks, phase after phase.
  std::span<Block const> blocks() const { return blocks_; }
  /// Phase k holds the blocks phase_begin()[k] ... phase_begin()[k+1]-1.
  std::span<std::size_t const> phase_begin() const { return phase_begin_; }
  std::size_t phase_count() const { return phase_begin_.size() - 1; }

 private:
  Block block_at(std::array<Index, 3> const& corner) const;

  Box box_;
  std::array<Index, 3> n_;
  std::vector<Block> blocks_;
  std::vector<std::size_t> phase_begin_{0};
};

} // namespace mesobridge::sdpd
