#pragma once
#include "workflows/scene/checks.hpp"

namespace mesobridge::workflows {

/// Throws InputError when the keys of a scene's reaction, or of its regions' progress, do not go together.
void check_reaction(Scene const& scene, Places const& places);

} // namespace mesobridge::workflows
