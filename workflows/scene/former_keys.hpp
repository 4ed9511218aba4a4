#pragma once
#include "workflows/scene/checks.hpp"
#include <string>
#include <toml++/toml.h>
#include <vector>

namespace mesobridge::workflows {

/// Says in the scene's table with the keys of today what it says with keys that are no more, and returns a
/// note for each. Throws InputError where an old key contradicts a new one, or has none of the values that it
/// had.
std::vector<std::string> read_former_keys(toml::table& scene, Places& places);

} // namespace mesobridge::workflows
