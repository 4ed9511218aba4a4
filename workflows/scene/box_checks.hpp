#pragma once
#include "workflows/scene/checks.hpp"

namespace mesobridge::workflows {

/// The rules of the box: how large it is, what its faces are, and what drives a flow in it. Throws
/// InputError.
void check_box(Scene const& scene, Places const& places);

} // namespace mesobridge::workflows
