#pragma once
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// What a run finds out about its own fluid before the first step. It stays in the folder, for any run of the
/// same fluid.
struct SceneFindings {
  Scene scene;         ///< with what was found
  Json densities = {}; ///< how their constants were found; null where the scene has them
  Json viscosity = {}; ///< how that of the friction of pairs was found; null where the scene has it
};

/// The constants of the densities and then the viscosity of the pairs' friction: those that the scene gives,
/// those that trials of the same fluid have left in the folder, or fresh ones. Throws as calibrate and
/// find_viscosity_of_pairs.
SceneFindings with_findings_about_fluid(Scene scene, RunFolder const& folder, RunOptions const& options);

} // namespace mesobridge::workflows
