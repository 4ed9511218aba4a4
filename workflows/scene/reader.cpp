#include "fitting/toml_depth.hpp"
#include "fitting/toml_reader.hpp"
#include "md/error.hpp"
#include "workflows/nearest.hpp"
#include "workflows/scene/box_checks.hpp"
#include "workflows/scene/checks.hpp"
#include "workflows/scene/former_keys.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/scene/pair_checks.hpp"
#include "workflows/scene/slot_reader.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <charconv>
#include <regex>
#include <sstream>
#include <toml++/toml.h>

namespace mesobridge::workflows {

namespace {

std::string text_of(toml::node const& node) {
  std::ostringstream out;
  out << toml::toml_formatter(node, toml::format_flags::none); // texts in double quotes, as people write them
  return out.str();
}

/// The right-hand side of --set: TOML if it is that, a text otherwise (so that the shell may eat the quotes).
toml::table override_value(std::string const& value) {
  auto const line = "value = " + value;
  fitting::refuse_deep_toml(line, "--set");
  try {
    auto table = toml::parse(line);
    if (table.size() == 1)
      return table;
  } catch (toml::parse_error const&) {
    // not TOML: it is taken as a text
  }
  return toml::table{{"value", value}};
}

/// The table that "region.2.rho" belongs to, of several; null if there is none.
toml::table* numbered(toml::array& tables, std::string const& path) {
  std::size_t number = 0;
  auto const* const end = path.data() + path.size();
  auto const* const begin = path.data() + path.find('.') + 1;
  auto const [rest, error] = std::from_chars(begin, end, number);
  bool const there =
      error == std::errc() && rest != end && *rest == '.' && number >= 1 && number <= tables.size();
  return there ? tables[number - 1].as_table() : nullptr;
}

void apply_override(toml::table& scene, std::string const& assignment, Places& places) {
  auto const equals = assignment.find('=');
  auto const path = assignment.substr(0, equals);
  auto const dot = path.find('.');
  if (equals == std::string::npos || path.empty() || dot == 0 || dot + 1 == path.size())
    throw InputError(fmt::format("--set {}: must be section.key=value", assignment));
  auto value = override_value(assignment.substr(equals + 1));
  auto* section = &scene;
  if (dot != std::string::npos) {
    auto const name = path.substr(0, dot);
    if (!scene[name].is_array())
      scene.insert(name, toml::table{});
    section = scene[name].is_array() ? numbered(*scene[name].as_array(), path) : scene[name].as_table();
    if (!section)
      throw InputError(fmt::format("--set {}: '{}' is no section of the scene", assignment,
                                   path.substr(0, path.rfind('.'))));
  }
  section->insert_or_assign(dot == std::string::npos ? path : path.substr(path.rfind('.') + 1),
                            *value.get("value"));
  places.note(path, "--set");
}

std::string const regions = "region";

/// Refuses a name that is none of the known ones.
void refuse_unknown(std::string const& section, std::string const& name, std::string const& place,
                    std::vector<std::string> const& known) {
  if (std::find(known.begin(), known.end(), name) != known.end())
    return;
  auto hint = did_you_mean(name, known);
  for (auto const& key : scene_keys())
    if (hint.empty() && key.name == name)
      hint = "; it belongs into " + (key.section.empty() ? "the top of the file" : "[" + key.section + "]");
  throw InputError(fmt::format("{}: unknown key '{}{}'{}; known: {}", place,
                               section.empty() ? "" : section + ".", name, hint, fmt::join(known, ", ")));
}

/// The same for the keys of one table.
void refuse_unknown_keys(toml::table const& table, std::string const& section,
                         std::vector<SceneKey> const& keys, Places& places) {
  std::vector<std::string> known;
  for (auto const& key : keys)
    if (key.section == section.substr(0, section.find('.')))
      known.push_back(key.name);
  for (auto const& [inner, value] : table) {
    auto const path = section + "." + std::string(inner.str());
    places.note(path, value.source().begin.line);
    refuse_unknown(section, std::string(inner.str()), places.of(path), known);
  }
}

void refuse_unknown_regions(toml::node const& node, Places& places) {
  auto const* tables = node.as_array();
  if (!tables || !tables->is_homogeneous<toml::table>())
    throw InputError(fmt::format("{}: {} = {}: must be tables, each [[{}]]", places.of(regions), regions,
                                 text_of(node), regions));
  for (std::size_t k = 0; k < tables->size(); ++k)
    refuse_unknown_keys(*(*tables)[k].as_table(), fmt::format("{}.{}", regions, k + 1), region_keys(k),
                        places);
}

/// Refuses keys and sections that no line of the table knows, and keys that stand in the wrong section.
void refuse_unknown(toml::table const& scene, Places& places) {
  std::vector<std::string> sections, top;
  for (auto const& key : scene_keys())
    (key.section.empty() ? top : sections).push_back(key.section.empty() ? key.name : key.section);
  for (auto const& section : sections)
    if (std::find(top.begin(), top.end(), section) == top.end())
      top.push_back(section);
  top.push_back(regions);
  for (auto const& [key, node] : scene) {
    std::string const name(key.str());
    places.note(name, node.source().begin.line);
    refuse_unknown("", name, places.of(name), top);
    if (name == regions)
      refuse_unknown_regions(node, places);
    if (std::find(sections.begin(), sections.end(), name) == sections.end())
      continue;
    if (!node.is_table())
      throw InputError(
          fmt::format("{}: {} = {}: must be a section, [{}]", places.of(name), name, text_of(node), name));
    refuse_unknown_keys(*node.as_table(), name, scene_keys(), places);
  }
}

/// Where a key stands in a file: "region[1].rho" for "region.2.rho".
std::string toml_path(std::string const& key) {
  static std::regex const numbered_table(R"(^(\w+)\.([1-9]\d{0,8})\.(\w+)$)");
  std::smatch parts;
  if (!std::regex_match(key, parts, numbered_table))
    return key;
  return fmt::format("{}[{}].{}", parts[1].str(), std::stoi(parts[2]) - 1, parts[3].str());
}

toml::node const* find(toml::table const& scene, SceneKey const& key) {
  return scene.at_path(toml_path(key.path())).node();
}

/// Reads one key, or sees that it need not be there.
void read_key(SceneKey const& key, toml::table const& table, Places const& places,
              std::filesystem::path const& file, Scene& scene) {
  auto const* node = find(table, key);
  bool const belongs = key.belongs_to(scene.method.name);
  if (node && !belongs)
    throw InputError(fmt::format("{}: key '{}' belongs to method.name = \"{}\", not to \"{}\"",
                                 places.of(key.path()), key.path(), fmt::join(key.methods, "\", \""),
                                 scene.method.name));
  if (!node && key.required && belongs)
    throw InputError(fmt::format("{}: key '{}' is missing ({}): must be {}", file.string(), key.path(),
                                 key.meaning, key.allowed(scene.units)));
  if (!node)
    return;
  if (auto const now = name_of_today(key, node->value_or(std::string())))
    scene.notes.push_back(fmt::format("{}: {} = {}: is called \"{}\" now", places.of(key.path()), key.path(),
                                      text_of(*node), *now));
  try {
    read_slot(*node, key, scene.units, key.slot(scene));
  } catch (InputError const& error) {
    throw InputError(
        fmt::format("{}: {} = {}: {}", places.of(key.path()), key.path(), text_of(*node), error.what()));
  }
}

} // namespace

Scene parse_scene(std::string const& text, std::filesystem::path const& file,
                  std::vector<std::string> const& overrides) {
  auto table = fitting::parse_toml(text, file.string());
  Places places(file.string());
  for (auto const& assignment : overrides)
    apply_override(table, assignment, places);
  auto const notes = read_former_keys(table, places);
  refuse_unknown(table, places);
  Scene scene; // `units` and the method stand first in the table, before the keys that depend on them
  if (auto const* const tables = table.get_as<toml::array>(regions))
    scene.regions.resize(tables->size());
  for (auto const& key : all_keys(scene))
    read_key(key, table, places, file, scene);
  scene.notes.insert(scene.notes.begin(), notes.begin(), notes.end());
  resolve_model_paths(scene, file.parent_path(), places);
  resolve_pair_files(scene, file.parent_path(), places);
  resolve_piston_file(scene, file.parent_path(), places);
  take_particle_model(scene, places);
  check_together(scene, places);
  return scene;
}

std::string place_of(std::filesystem::path const& file, std::vector<std::string> const& overrides,
                     std::string const& key) {
  auto table = fitting::parse_toml(read_text_file(file), file.string());
  Places places(file.string());
  for (auto const& assignment : overrides)
    apply_override(table, assignment, places);
  if (auto const* node = table.at_path(toml_path(key)).node())
    places.note(key, node->source().begin.line);
  return places.of(key);
}

Scene load_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides) {
  return parse_scene(read_text_file(file), file, overrides);
}

} // namespace mesobridge::workflows
