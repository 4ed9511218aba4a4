#pragma once
#include "md/error.hpp"
#include "replaced.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::tests {

/// What is wrong with the text of a scene.
inline std::string error_of(std::string const& text, std::vector<std::string> const& overrides = {}) {
  try {
    workflows::parse_scene(text, "bad.toml", overrides);
  } catch (InputError const& error) {
    return error.what();
  }
  return "no error";
}

} // namespace mesobridge::tests
