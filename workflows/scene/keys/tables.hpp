#pragma once
#include "sdpd/state/parameter.hpp"
#include "workflows/scene/keys.hpp"
#include <algorithm>

namespace mesobridge::workflows {

/// The keys of a scene's tables, for scene_keys().
std::vector<SceneKey> title_and_method_keys();
std::vector<SceneKey> fluid_keys();
std::vector<SceneKey> particle_keys();
std::vector<SceneKey> box_keys();
std::vector<SceneKey> pair_fluid_keys(); ///< potential, friction, internal energy, conduction
std::vector<SceneKey> potential_keys();
std::vector<SceneKey> transport_keys();
std::vector<SceneKey> reaction_keys();
std::vector<SceneKey> scheme_keys();
std::vector<SceneKey> run_keys();
std::vector<SceneKey> observe_keys(); ///< profile, histogram, series
std::vector<SceneKey> output_keys();

/// The parameters of all pair potentials, each name once.
std::vector<sdpd::Parameter> potential_parameters();

/// The same of all laws of kinetics.
std::vector<sdpd::Parameter> kinetics_parameters();

/// The parameters of all laws of a list that describe themselves, each name once, in an order that keeps each
/// law's own: a new parameter stands before those of its law that are there already.
template <class NamedLaw>
std::vector<sdpd::Parameter> parameters_of(std::vector<NamedLaw> const& laws) {
  std::vector<sdpd::Parameter> all;
  auto const place = [&](std::string_view name) {
    return std::ranges::find(all, name, &sdpd::Parameter::name);
  };
  for (auto const& law : laws)
    for (std::size_t k = 0; k < law.parameters.size(); ++k) {
      if (place(law.parameters[k].name) != all.end())
        continue;
      auto before = all.end();
      for (std::size_t later = k + 1; later < law.parameters.size(); ++later)
        before = std::min(before, place(law.parameters[later].name));
      all.insert(before, law.parameters[k]);
    }
  return all;
}

/// The names of the laws that have a parameter.
template <class NamedLaw>
std::vector<std::string> names_with(std::vector<NamedLaw> const& laws, std::string_view parameter) {
  std::vector<std::string> names;
  for (auto const& law : laws)
    if (std::ranges::find(law.parameters, parameter, &sdpd::Parameter::name) != law.parameters.end())
      names.emplace_back(law.name);
  return names;
}

} // namespace mesobridge::workflows
