#pragma once
#include "workflows/scene/checks.hpp"
#include <optional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// A key that may be there, and the names that want it.
struct WantedKey {
  std::string key;
  bool given;
  std::vector<std::string> by;
};

/// Keys that `name`, the value of the key `what`, wants must be given, the others not. Throws InputError.
void check_wanted(std::string const& what, std::string const& name, std::vector<WantedKey> const& keys,
                  Places const& places);

} // namespace mesobridge::workflows
