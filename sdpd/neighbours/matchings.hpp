#pragma once
#include "sdpd/neighbours/neighbours.hpp"

namespace mesobridge::sdpd {

/// Orders pairs of `particles` particles in matchings, sets of pairs that share no particle: each pair goes
/// to the first matching in which both its particles are free (a greedy edge colouring, at most twice as many
/// matchings as the busiest particle has pairs). `ends` is where each matching ends in `ordered`.
void order_in_matchings(std::span<LocalPair const> pairs, std::size_t particles,
                        std::vector<LocalPair>& ordered, std::vector<std::uint32_t>& ends);

} // namespace mesobridge::sdpd
