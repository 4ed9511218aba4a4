#pragma once
#include "sdpd/start/layout.hpp"
#include <optional>

namespace mesobridge::sdpd {

/// How many of these sites belong to region number `region` of a list of which each takes from those before
/// it, without a walk through all of them. Nothing for more than 64 regions, or where one is no cuboid (or
/// all but one).
std::optional<std::size_t> count_sites(Coordinates const& sites, std::vector<Region> const& regions,
                                       std::size_t region);

} // namespace mesobridge::sdpd
