#include "workflows/scene/reaction_checks.hpp"
#include "md/error.hpp"
#include "sdpd/kinetics/list.hpp"
#include "workflows/scene/keys/tables.hpp"
#include "workflows/scene/wanted_keys.hpp"

namespace mesobridge::workflows {
namespace {

/// Without a product there is nothing to be said of a reaction.
void check_none(Scene const& scene, Places const& places) {
  auto const refuse = [&](std::string const& key) {
    throw InputError(
        fmt::format("{}: key '{}' needs reaction.product: without it nothing reacts", places.of(key), key));
  };
  auto const& reaction = scene.reaction;
  Scene::Reaction const fresh;
  for (auto const& [key, given] : {std::pair("heat", reaction.heat.has_value()),
                                   {"heat_per_molecule", reaction.heat_per_molecule.has_value()},
                                   {"volumes", reaction.volumes != fresh.volumes},
                                   {"kinetics", reaction.kinetics != fresh.kinetics},
                                   {"weights", reaction.weights != fresh.weights},
                                   {"integrator", reaction.integrator != fresh.integrator},
                                   {"progress", reaction.progress != fresh.progress}})
    if (given)
      refuse(fmt::format("reaction.{}", key));
  for (auto const& parameter : kinetics_parameters())
    if (reaction.parameters[parameter.name])
      refuse(fmt::format("reaction.{}", parameter.name));
  for (std::size_t k = 0; k < scene.regions.size(); ++k)
    if (scene.regions[k].progress)
      refuse(fmt::format("region.{}.progress", k + 1));
}

void check_kinetics(Scene const& scene, Places const& places) {
  auto const& reaction = scene.reaction;
  auto const keys = parameter_keys("reaction", kinetics_parameters(), reaction.parameters, sdpd::kinetics());
  check_wanted("reaction.kinetics", reaction.kinetics, keys, places);
  require_together(reaction.weights == "kernel" || reaction.kinetics.starts_with("second-order"), places,
                   "reaction.weights", reaction.weights,
                   "allowed with second-order kinetics only: neighbours have no part in the others");
}

void check_regions_react(Scene const& scene, Places const& places) {
  for (std::size_t k = 0; k < scene.regions.size(); ++k) {
    auto const& region = scene.regions[k];
    auto const key = [&](char const* name) { return fmt::format("region.{}.{}", k + 1, name); };
    require_together(!region.eos || *region.eos == scene.fluid.eos, places, key("eos"),
                     region.eos.value_or(""), "must be fluid.eos in a fluid that reacts");
    require_together(!region.K || *region.K == scene.particles.K, places, key("K"), region.K.value_or(0),
                     "must be particles.K in a fluid that reacts");
    require_together(!region.progress || region.fill == "fluid", places, key("progress"),
                     region.progress.value_or(0), "must not be given: the region is vacuum");
  }
}

} // namespace

void check_reaction(Scene const& scene, Places const& places) {
  auto const& reaction = scene.reaction;
  if (!reaction.product)
    return check_none(scene, places);
  require_together(reaction.heat.has_value() != reaction.heat_per_molecule.has_value(), places,
                   "reaction.product", *reaction.product,
                   "needs the heat of reaction: one of reaction.heat and reaction.heat_per_molecule");
  check_kinetics(scene, places);
  check_regions_react(scene, places);
}

} // namespace mesobridge::workflows
