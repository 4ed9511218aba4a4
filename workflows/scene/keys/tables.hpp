#pragma once
#include "sdpd/state/parameter.hpp"
#include "workflows/scene/keys.hpp"

namespace mesobridge::workflows {

/// The keys of a scene's tables, for scene_keys().
std::vector<SceneKey> title_and_method_keys();
std::vector<SceneKey> fluid_keys();
std::vector<SceneKey> particle_keys();
std::vector<SceneKey> box_keys();
std::vector<SceneKey> pair_fluid_keys(); ///< potential, friction, internal energy, conduction
std::vector<SceneKey> potential_keys();
std::vector<SceneKey> transport_keys();
std::vector<SceneKey> scheme_keys();
std::vector<SceneKey> run_keys();
std::vector<SceneKey> observe_keys(); ///< profile, histogram, series
std::vector<SceneKey> output_keys();

/// The parameters of all pair potentials, each name once.
std::vector<sdpd::Parameter> potential_parameters();

} // namespace mesobridge::workflows
