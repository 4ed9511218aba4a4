#pragma once
#include "md/error.hpp"
#include "workflows/scene/scene.hpp"
#include <map>
#include <string>

namespace mesobridge::workflows {

/// Where each key of a scene was given: "scene.toml:7" or "--set".
class Places {
 public:
  explicit Places(std::string file) : file_(std::move(file)) {}

  /// The first note of a path stays: --set is noted before the file.
  void note(std::string const& path, std::string const& place) { places_.emplace(path, place); }
  void note(std::string const& path, unsigned line) { note(path, file_ + ":" + std::to_string(line)); }

  bool given(std::string const& path) const { return places_.contains(path); }

  /// The place of a key, or the file for a key that was not given.
  std::string of(std::string const& path) const {
    auto const found = places_.find(path);
    return found == places_.end() ? file_ : found->second;
  }

 private:
  std::string file_;
  std::map<std::string, std::string> places_;
};

/// Throws InputError that names the place, the key and its value, unless the condition holds.
template <class Value>
void require_together(bool condition, Places const& places, std::string const& key, Value const& value,
                      std::string const& what_is_allowed) {
  require(condition, places.of(key) + ": " + key, value, what_is_allowed);
}

/// Where a key ("run.steps") of a scene file stands: "scene.toml:7", "--set", or the file when it has none.
std::string place_of(std::filesystem::path const& file, std::vector<std::string> const& overrides,
                     std::string const& key);

/// Turns the paths of fitted models into absolute ones, so that the resolved scene reads back from any
/// folder; the files must be there. Throws InputError.
void resolve_model_paths(Scene& scene, std::filesystem::path const& folder, Places const& places);

/// The rules that concern several keys at once. Throws InputError.
void check_together(Scene const& scene, Places const& places);

} // namespace mesobridge::workflows
