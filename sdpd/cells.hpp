#pragma once
#include "md/box.hpp"
#include "sdpd/particles.hpp"
#include <array>
#include <span>

namespace mesobridge::sdpd {

/// All pairs between two neighbouring cells (or within one). `shift` is the periodic image: the separation of
/// i in `first` and j in `second` is q_i - q_j - shift.
struct CellPair {
  Index first, second;
  Vec3 shift;
};

/// A grid of cells whose edges are at least the range of the interaction, and the cell pairs (half stencil)
/// in phases: within one phase no two cell pairs share a cell, so that threads may treat them at the same
/// time, and the result of a sweep depends on the order of the phases alone, not on the number of threads.
class CellGrid {
 public:
  /// Throws InputError when an edge of the box is shorter than twice the range.
  CellGrid(Box box, double range);

  std::size_t cell_count() const { return std::size_t{n_[0]} * n_[1] * n_[2]; }
  Index cell_of(Vec3 const& q_wrapped) const;

  /// The cell pairs, phase after phase.
  std::span<CellPair const> pairs() const { return pairs_; }
  /// Phase k holds the pairs phase_begin()[k] ... phase_begin()[k+1]-1.
  std::span<std::size_t const> phase_begin() const { return phase_begin_; }
  std::size_t phase_count() const { return phase_begin_.size() - 1; }

 private:
  CellPair neighbour(Index cell, std::array<int, 3> const& offset) const;
  void colour(std::array<int, 3> const& offset);

  Box box_;
  std::array<Index, 3> n_;
  std::vector<CellPair> pairs_;
  std::vector<std::size_t> phase_begin_{0};
};

} // namespace mesobridge::sdpd
