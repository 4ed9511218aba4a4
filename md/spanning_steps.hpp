#pragma once
#include <utility>
#include <vector>

namespace mesobridge::md {

/// Steps along bonds from atom 0 that reach every atom; an atom without a bond to the rest is reached from
/// atom 0 itself. Each step goes from an atom that was reached before.
std::vector<std::pair<int, int>> spanning_steps(int atoms, std::vector<std::pair<int, int>> const& bonds);

} // namespace mesobridge::md
