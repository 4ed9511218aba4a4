#pragma once
#include "sdpd/neighbours/block_copy.hpp"

namespace mesobridge::sdpd {

/// Working memory of select_pairs.
struct SelectionScratch {
  std::vector<double> r2;            ///< |r|^2 of the pairs in range, where they are wanted
  std::vector<std::uint32_t> before; ///< pairs in range before each group of candidates
  std::vector<std::uint16_t> bits;   ///< which of a group are in range
};

/// Picks the pairs in range of a block, whose particles' positions are in `rows`, from its candidates, with
/// their |r|^2.
void select_pairs_and_distances(Neighbours& neighbours, std::size_t block, std::vector<Row> const& rows,
                                SelectionScratch& scratch);

/// The same in single precision, without distances: pairs that are out of range by up to 1e-5 reaches may be
/// in it.
void select_pairs(Neighbours& neighbours, std::size_t block, std::vector<FloatRow> const& rows,
                  SelectionScratch& scratch);

} // namespace mesobridge::sdpd
