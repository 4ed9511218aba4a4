#pragma once
#include "workflows/scene/checks.hpp"

namespace mesobridge::workflows {

/// The rules of DPD and DPDE scenes that concern several keys at once. Throws InputError.
void check_pair_fluid(Scene const& scene, Places const& places);

/// Turns the paths of tables and models into absolute ones; the files must be there. Throws InputError.
void resolve_pair_files(Scene& scene, std::filesystem::path const& folder, Places const& places);

} // namespace mesobridge::workflows
