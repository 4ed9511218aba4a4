#pragma once
#include "sdpd/method/settings.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// Whether the scene says where its particles begin otherwise than as one fluid on one lattice.
bool has_layout(Scene const& scene);

/// Gives settings that hold all but this the layout of the scene's box and regions, and the species of their
/// particles. Throws InputError that names the region that cannot be.
void lay_out(Scene const& scene, sdpd::SimulationSettings& settings);

} // namespace mesobridge::workflows
