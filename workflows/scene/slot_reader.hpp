#pragma once
#include "workflows/scene/keys.hpp"
#include <toml++/toml.h>

namespace mesobridge::workflows {

/// What a text that was allowed once is called now.
std::optional<std::string> name_of_today(SceneKey const& key, std::string const& text);

/// Stores one node where its key wants it; throws InputError without place and key, which the caller adds.
void read_slot(toml::node const& node, SceneKey const& key, UnitSystem units, Slot const& slot);

} // namespace mesobridge::workflows
