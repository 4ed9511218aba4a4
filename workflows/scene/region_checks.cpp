#include "workflows/scene/region_checks.hpp"
#include "md/error.hpp"

namespace mesobridge::workflows {
namespace {

/// A region's keys that must, or must not, stand together.
struct RegionRules {
  Scene::Region const& region;
  std::size_t number;
  Places const& places;

  template <class Value>
  void require(bool condition, std::string const& key, Value const& value, std::string const& allowed) const {
    auto const path = fmt::format("region.{}.{}", number, key);
    mesobridge::require(condition, places.of(path) + ": " + path, value, allowed);
  }

  void check() const {
    bool const round = region.shape == "sphere" || region.shape == "cylinder";
    require(round == region.radius.has_value(), "radius", region.radius.value_or(0),
            round ? "must be given, > 0, for a " + region.shape
                  : "must not be given: a " + region.shape + " has none");
    check_places("centre", region.centre, round ? 3 : 0);
    std::size_t const ends = region.shape == "block" ? 3 : region.shape == "sphere" ? 0 : 1;
    check_places("from", region.from, ends);
    check_places("to", region.to, ends);
    check_state();
  }

  void check_places(std::string const& key, std::vector<Coordinate> const& given, std::size_t wanted) const {
    if (!given.empty())
      require(given.size() == wanted, key, given.size(),
              wanted == 0 ? fmt::format("places; a {} has none", region.shape)
                          : fmt::format("places; must be {} for a {}", wanted, region.shape));
  }

  /// Vacuum has no state.
  void check_state() const {
    for (auto const& [key, value] : {std::pair("K", region.K),
                                     {"rho", region.rho},
                                     {"T", region.T},
                                     {"mass", region.mass},
                                     {"heat_capacity", region.heat_capacity}})
      if (value)
        require(region.fill == "fluid", key, *value, "must not be given: the region is vacuum");
  }
};

/// Whether the region is not at rest, or would not stay as it is beside the fluid.
bool must_not_settle(Scene::Region const& region) {
  return region.fill == "vacuum" || region.T || (region.rho && !region.eos) || !region.velocity.empty() ||
         !region.velocity_gradient.empty() || region.progress;
}

} // namespace

void check_regions(Scene const& scene, Places const& places) {
  for (std::size_t k = 0; k < scene.regions.size(); ++k) {
    RegionRules{scene.regions[k], k + 1, places}.check();
    if (must_not_settle(scene.regions[k]))
      require(scene.run.equilibrate == 0, places.of("run.equilibrate") + ": run.equilibrate",
              scene.run.equilibrate,
              "must be 0: the regions would not begin as the scene says, but as they have become by then");
  }
}

} // namespace mesobridge::workflows
