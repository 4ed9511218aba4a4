#include "workflows/sdpd/known_structure.hpp"
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>

namespace mesobridge::workflows {
namespace {

/// Where a kernel does not make a fluid: `reproduce structure`, argon at 1150 kg/m^3, 1000 K and 2 mPa s,
/// melted starts, 343 and 512 particles, 150 reduced times (workflows/README.md). Bounds lie where it was
/// seen, not between.
struct NoFluid {
  char const* kernel;
  double neighbours_from, neighbours_to, K_from;
  char const *becomes, *instead;
};
constexpr double any = std::numeric_limits<double>::infinity();
constexpr std::array no_fluids{
    NoFluid{"cubic", 109, any, 10, "pair, 10 % of them and with K = 1000 nine of ten",
            "kernel = \"wendland-c4\""},
    NoFluid{"cubic", 64, any, 1000, "pair, more than a third of them", "kernel = \"wendland-c4\""},
    NoFluid{"wendland-c2", 0, 66, 1e4, "turn into a crystal, though they begin without a lattice",
            "kernel = \"wendland-c4\" with 65 neighbours or more"}};

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
