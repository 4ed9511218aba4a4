#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// JSON Schema (draft 07) of scene files, made of the table of their keys: an editor that knows schemas of
/// TOML completes keys, explains them and marks what is no key or no allowed value. What depends on other
/// keys is left to `check`.
Json scene_schema();

/// The same of files of equations of state.
Json model_schema();

} // namespace mesobridge::workflows
