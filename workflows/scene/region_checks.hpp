#pragma once
#include "workflows/scene/checks.hpp"

namespace mesobridge::workflows {

/// The rules of regions: which keys go with which shape, and that regions that differ are not brought to
/// equilibrium with each other. Throws InputError.
void check_regions(Scene const& scene, Places const& places);

} // namespace mesobridge::workflows
