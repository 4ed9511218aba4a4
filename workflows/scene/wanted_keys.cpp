#include "workflows/scene/wanted_keys.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <fmt/ranges.h>

namespace mesobridge::workflows {

void check_wanted(std::string const& what, std::string const& name, std::vector<WantedKey> const& keys,
                  Places const& places) {
  for (auto const& [key, given, by] : keys) {
    bool const wanted = std::ranges::find(by, name) != by.end();
    if (wanted && !given)
      throw InputError(
          fmt::format("{}: key '{}' is missing, which {} = \"{}\" needs", places.of(what), key, what, name));
    if (!wanted && given)
      throw InputError(fmt::format("{}: key '{}' belongs to {} = \"{}\", not to \"{}\"", places.of(key), key,
                                   what, fmt::join(by, "\", \""), name));
  }
}

} // namespace mesobridge::workflows
