#pragma once
#include "workflows/scene/checks.hpp"

namespace mesobridge::workflows {

/// Turns the path of a piston's table into an absolute one; the file must be there. Throws InputError.
void resolve_piston_file(Scene& scene, std::filesystem::path const& folder, Places const& places);

/// The rules of the box: how large it is, what its faces are, and what drives a flow in it. Throws
/// InputError.
void check_box(Scene const& scene, Places const& places);

} // namespace mesobridge::workflows
