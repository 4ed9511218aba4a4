#include "sdpd/start/count_sites.hpp"
#include <algorithm>
#include <bit>
#include <map>

namespace mesobridge::sdpd {
namespace {

/// Bit r: the coordinate lies between the planes of cuboid r.
using Mask = std::uint64_t;

/// How many coordinates along an axis lie between the planes of the same cuboids.
std::map<Mask, std::size_t> counts_along(int axis, std::vector<double> const& at,
                                         std::vector<Region> const& regions) {
  std::map<Mask, std::size_t> counts;
  for (double const x : at) {
    Mask mask = 0;
    for (std::size_t r = 0; r < regions.size(); ++r) {
      auto const& cuboid = std::get<Cuboid>(regions[r].shape);
      if (x >= component(cuboid.from, axis) && x < component(cuboid.to, axis))
        mask |= Mask{1} << r;
    }
    ++counts[mask];
  }
  return counts;
}

} // namespace

std::optional<std::size_t> count_sites(Coordinates const& sites, std::vector<Region> const& regions,
                                       std::size_t region) {
  auto const is_cuboid = [](Region const& of) { return std::holds_alternative<Cuboid>(of.shape); };
  if (regions.size() > 64 || !std::ranges::all_of(regions, is_cuboid))
    return std::nullopt;
  Mask outside = 0;
  for (std::size_t r = 0; r < regions.size(); ++r)
    outside |= Mask{regions[r].outside} << r;
  std::array<std::map<Mask, std::size_t>, 3> along;
  for (std::size_t axis = 0; axis < 3; ++axis)
    along[axis] = counts_along(static_cast<int>(axis), sites[axis], regions);
  std::size_t count = 0;
  for (auto const& [x, of_x] : along[0])
    for (auto const& [y, of_y] : along[1])
      for (auto const& [z, of_z] : along[2]) {
        Mask const holding = (x & y & z) ^ outside;
        if (holding != 0 && static_cast<std::size_t>(std::bit_width(holding)) == region + 1)
          count += of_x * of_y * of_z;
      }
  return count;
}

} // namespace mesobridge::sdpd
