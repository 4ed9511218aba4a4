#pragma once
#include "sdpd/state/wall_motion.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// The motion of the piston by the scene's table, in the scene's keys or in a file, in the scene's units; at
/// rest where there is none. Throws InputError that names file and row.
sdpd::WallMotion piston_table(Scene const& scene);

} // namespace mesobridge::workflows
