#pragma once
#include "sdpd/method/settings.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// Where the particles of a scene begin: a layer of them through the middle of the box, the box's longest
/// edge to the right, each region in a colour of its own. At most some thousand points.
Plot start_picture(Scene const& scene, sdpd::SimulationSettings const& settings);

/// What each region holds, a line each: particles, their size, and the density that their lattice has.
/// Nothing for a box of one fluid.
std::vector<std::string> region_lines(Scene const& scene, sdpd::SimulationSettings const& settings);

} // namespace mesobridge::workflows
