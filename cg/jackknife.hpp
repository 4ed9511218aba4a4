#pragma once
#include "cg/estimate.hpp"
#include <functional>

namespace mesobridge::cg {

/// Sums over the samples of one block; all blocks have the same sums.
using Sums = std::vector<double>;

/// The jackknife estimate of a number from what it is with all blocks and without each in turn: freed from
/// its O(1/blocks) bias; n_eff is the number of blocks.
Estimate jackknifed(double whole, std::span<double const> without);

/// Sums of all blocks but one, for each; the last entry leaves none out.
std::vector<Sums> without_each(std::span<Sums const> blocks);

/// Any statistics that are functions of additive sums, with their jackknife errors over blocks left out in
/// turn and freed from their O(1/blocks) bias. The blocks must be independent: several correlation times
/// long. n_eff is the number of blocks. At least 4 blocks.
std::vector<Estimate> jackknife(std::span<Sums const> blocks,
                                std::function<std::vector<double>(Sums const&)> const& statistics);

} // namespace mesobridge::cg
