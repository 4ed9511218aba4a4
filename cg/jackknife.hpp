#pragma once
#include "cg/estimate.hpp"

namespace mesobridge::cg {

/// Sums over the samples of one block; all blocks have the same sums.
using Sums = std::vector<double>;

/// Any statistics that are functions of additive sums, with their jackknife errors over blocks left out in
/// turn and freed from their O(1/blocks) bias. The blocks must be independent: several correlation times
/// long. n_eff is the number of blocks. At least 4 blocks.
std::vector<Estimate> jackknife(std::span<Sums const> blocks,
                                std::function<std::vector<double>(Sums const&)> const& statistics);

} // namespace mesobridge::cg
