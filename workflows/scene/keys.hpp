#pragma once
#include "md/number_range.hpp"
#include "workflows/quantity.hpp"
#include "workflows/scene/scene.hpp"
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace mesobridge::workflows {

/// Where a key's value lives in the scene; the alternative says what type the key has.
using Slot = std::variant<std::string*, std::optional<std::string>*, std::int64_t*, double*,
                          std::optional<double>*, std::vector<std::string>*, std::vector<std::int64_t>*,
                          std::vector<double>*, std::vector<Coordinate>*, TimeStep*, UnitSystem*>;

/// One key of a scene file.
struct SceneKey {
  std::string section; ///< empty for the keys at the top
  std::string name;
  std::optional<std::size_t> number; ///< of its table, from 1 on, where there may be several: [[region]]
  std::function<Slot(Scene&)> slot;
  std::optional<Dimension> dimension; ///< of a quantity: then SI scenes give it as a string with a unit
  NumberRange range;
  /// Texts that were allowed once, and what they are called now.
  std::vector<std::pair<std::string, std::string>> former;
  std::vector<std::string> choices;          ///< of a text, or of the texts of a list; empty: any
  bool any_length = false;                   ///< of a list of numbers; else it has three, along x, y and z
  bool required = false;                     ///< if not, the default is that of a fresh Scene
  std::vector<std::string> methods;          ///< the methods that have the key; empty: all
  std::function<bool(Scene const&)> written; ///< whether resolved scenes show it; empty: always
  std::string meaning;

  bool belongs_to(std::string const& method) const;
  bool is_list() const;
  /// "run.steps"; "region.2.rho" of the second of several tables.
  std::string path() const {
    return section.empty() ? name : section + (number ? "." + std::to_string(*number) : "") + "." + name;
  }
  /// What the key allows, in words: "a density > 0 such as \"1 kg/m^3\"".
  std::string allowed(UnitSystem units) const;
};

/// All keys, in the order in which a scene is written. A new section or key is a line here and a member of
/// Scene.
std::vector<SceneKey> const& scene_keys();

/// The keys of the scene's region number `index`, from 0 on, in their order; their section is "region".
std::vector<SceneKey> region_keys(std::size_t index);

/// The keys of all tables, with those of each of the scene's regions.
std::vector<SceneKey> all_keys(Scene const& scene);

/// The key's value as TOML, or nothing if it is not set.
std::optional<std::string> value_text(SceneKey const& key, Scene const& scene);

} // namespace mesobridge::workflows
