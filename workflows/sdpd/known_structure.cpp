#include "workflows/sdpd/known_structure.hpp"
#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// Where a kernel does not make a fluid: `reproduce structure`, argon at 1150 kg/m^3, 1000 K and 2 mPa s,
/// melted starts, 343 and 512 particles, 150 reduced times (workflows/README.md), several seeds where it is
/// chance. Bounds lie near the numbers of neighbours where it was seen.
struct NoFluid {
  char const* kernel;
  double neighbours_from, neighbours_to, K_from;
  char const *becomes, *instead;
};
constexpr std::array no_fluids{
    NoFluid{"cubic", 100, 120, 10, "pair, 10 % of them and with K = 1000 nine of ten",
            "kernel = \"wendland-c4\""},
    NoFluid{"cubic", 60, 70, 1000, "pair, more than a third of them", "kernel = \"wendland-c4\""},
    NoFluid{"wendland-c2", 25, 35, 1e4, "turn into a crystal in part, though they begin without a lattice",
            "kernel = \"wendland-c4\" with 65 neighbours"},
    NoFluid{"wendland-c2", 60, 70, 1e4,
            "may turn into a crystal, though they begin without a lattice (3 of 6 runs at K = 10^4, 6 of 6 "
            "at 10^6)",
            "kernel = \"wendland-c4\" with 65 neighbours"},
    NoFluid{"wendland-c4", 100, 120, 1e6,
            "may turn into a crystal, though they begin without a lattice (2 of 8 runs)", "65 neighbours"}};

} // namespace

std::optional<std::string> known_structure(std::string const& kernel, double neighbours, double K) {
  auto const found = std::ranges::find_if(no_fluids, [&](NoFluid const& of) {
    return of.kernel == kernel && neighbours >= of.neighbours_from && neighbours <= of.neighbours_to &&
           K >= of.K_from;
  });
  if (found == no_fluids.end())
    return std::nullopt;
  return fmt::format(
      "with kernel = \"{}\", {:.0f} neighbours and K = {:g} particles of argon {} (`mesobridge reproduce "
      "structure`); take {}",
      kernel, neighbours, K, found->becomes, found->instead);
}

} // namespace mesobridge::workflows
