#pragma once
#include "md/number_range.hpp"
#include "workflows/command.hpp"
#include <cmath>

namespace mesobridge::workflows {

/// Bounds of a number in a schema; a text with a unit passes them.
inline void put_bounds(Json& schema, NumberRange const& range) {
  if (std::isfinite(range.min))
    schema[range.open ? "exclusiveMinimum" : "minimum"] = range.min;
  if (std::isfinite(range.max))
    schema["maximum"] = range.max;
}

/// JSON Schema (draft 07) of scene files, made of the table of their keys: an editor that knows schemas of
/// TOML completes keys, explains them and marks what is no key or no allowed value. What depends on other
/// keys is left to `check`.
Json scene_schema();

/// The same of files of equations of state.
Json model_schema();

} // namespace mesobridge::workflows
