#pragma once
#include "sdpd/state/units.hpp"
#include "workflows/scene/scene.hpp"
#include <string>

namespace mesobridge::workflows {

/// For a cluster with Slurm; a page of its manual tells what else may stand there.
std::string batch_script();

/// How the plugin is built where the user's own LAMMPS is, what the files are, and their units.
std::string plugin_page(Scene const& scene, sdpd::ReducedUnits const& units);

} // namespace mesobridge::workflows
