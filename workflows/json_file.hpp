#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Reads a JSON file. Throws InputError that names it when it is none.
Json read_json(std::filesystem::path const& file);

} // namespace mesobridge::workflows
