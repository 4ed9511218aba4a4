#pragma once
#include "workflows/scene/checks.hpp"
#include "workflows/scene/keys/tables.hpp"
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

/// The keys of the parameters of laws, all in one table; those laws want each that have it. `given` holds
/// what the scene says.
template <class Parameters, class Given, class Laws>
std::vector<WantedKey> parameter_keys(std::string const& table, Parameters const& parameters,
                                      Given const& given, Laws const& laws) {
  std::vector<WantedKey> keys;
  for (auto const& parameter : parameters)
    keys.push_back({fmt::format("{}.{}", table, parameter.name), given[parameter.name].has_value(),
                    names_with(laws, parameter.name)});
  return keys;
}

/// Keys that `name`, the value of the key `what`, wants must be given, the others not. Throws InputError.
void check_wanted(std::string const& what, std::string const& name, std::vector<WantedKey> const& keys,
                  Places const& places);

} // namespace mesobridge::workflows
