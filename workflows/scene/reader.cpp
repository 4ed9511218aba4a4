#include "fitting/toml_depth.hpp"
#include "fitting/toml_reader.hpp"
#include "md/error.hpp"
#include "workflows/nearest.hpp"
#include "workflows/scene/checks.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/scene/pair_checks.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <charconv>
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
    scene.insert(name, toml::table{});
    section = scene[name].as_table();
    if (!section)
      throw InputError(fmt::format("--set {}: '{}' is no section of the scene", assignment, name));
  }
  section->insert_or_assign(dot == std::string::npos ? path : path.substr(dot + 1), *value.get("value"));
  places.note(path, "--set");
}

/// Refuses keys and sections that no line of the table knows, and keys that stand in the wrong section.
void refuse_unknown(toml::table const& scene, Places& places) {
  std::vector<std::string> sections, top_names;
  for (auto const& key : scene_keys())
    (key.section.empty() ? top_names : sections).push_back(key.section.empty() ? key.name : key.section);
  auto const check = [&](std::string const& section, std::string const& name, std::string const& place,
                         std::vector<std::string> const& known) {
    if (std::find(known.begin(), known.end(), name) != known.end())
      return;
    auto hint = did_you_mean(name, known);
    for (auto const& key : scene_keys())
      if (hint.empty() && key.name == name)
        hint = "; it belongs into " + (key.section.empty() ? "the top of the file" : "[" + key.section + "]");
    throw InputError(fmt::format("{}: unknown key '{}{}'{}; known: {}", place,
                                 section.empty() ? "" : section + ".", name, hint, fmt::join(known, ", ")));
  };
  auto top = top_names;
  for (auto const& section : sections)
    if (std::find(top.begin(), top.end(), section) == top.end())
      top.push_back(section);
  for (auto const& [key, node] : scene) {
    std::string const name(key.str());
    places.note(name, node.source().begin.line);
    check("", name, places.of(name), top);
    if (std::find(sections.begin(), sections.end(), name) == sections.end())
      continue;
    if (!node.is_table())
      throw InputError(
          fmt::format("{}: {} = {}: must be a section, [{}]", places.of(name), name, text_of(node), name));
    std::vector<std::string> known;
    for (auto const& k : scene_keys())
      if (k.section == name)
        known.push_back(k.name);
    for (auto const& [inner, value] : *node.as_table()) {
      auto const path = name + "." + std::string(inner.str());
      places.note(path, value.source().begin.line);
      check(name, std::string(inner.str()), places.of(path), known);
    }
  }
}

/// What a text that was allowed once is called now.
std::optional<std::string> name_of_today(SceneKey const& key, std::string const& text) {
  auto const found = std::ranges::find(key.former, text, &std::pair<std::string, std::string>::first);
  return found == key.former.end() ? std::nullopt : std::optional(found->second);
}

/// Stores one node where its key wants it; throws InputError without place and key, which the caller adds.
struct SlotReader {
  toml::node const& node;
  SceneKey const& key;
  UnitSystem units;

  [[noreturn]] void refuse() const { throw InputError("must be " + key.allowed(units)); }

  std::string text() const { return text(node); }

  std::string text(toml::node const& of) const {
    auto value = of.value_exact<std::string>();
    if (!value)
      refuse();
    if (auto const now = name_of_today(key, *value))
      value = *now;
    if (!key.choices.empty() &&
        std::find(key.choices.begin(), key.choices.end(), *value) == key.choices.end())
      throw InputError("must be " + key.allowed(units) + did_you_mean(*value, key.choices));
    return *value;
  }

  double number() const {
    auto const whole = node.value_exact<std::int64_t>(); // value<double>() is empty for those above 2^53
    auto const value = whole ? static_cast<double>(*whole) : node.value_exact<double>();
    if (!value || !key.range.contains(*value))
      refuse();
    return *value;
  }

  double quantity() const {
    if (!key.dimension || units == UnitSystem::lj)
      return number();
    if (!node.is_string())
      throw InputError(fmt::format("a unit is missing; must be {}", key.allowed(units)));
    double const value = parse_quantity(*node.value_exact<std::string>(), *key.dimension);
    if (!key.range.contains(value))
      refuse();
    return value;
  }

  void operator()(std::string* slot) const { *slot = text(); }
  void operator()(std::optional<std::string>* slot) const { *slot = text(); }
  void operator()(UnitSystem* slot) const { *slot = text() == "SI" ? UnitSystem::SI : UnitSystem::lj; }
  void operator()(double* slot) const { *slot = quantity(); }
  void operator()(std::optional<double>* slot) const { *slot = quantity(); }
  void operator()(std::int64_t* slot) const {
    auto const value = node.value_exact<std::int64_t>();
    if (!value || !key.range.contains(static_cast<double>(*value)))
      refuse();
    *slot = *value;
  }
  void operator()(std::vector<std::string>* slot) const {
    auto const* list = node.as_array();
    if (!list)
      refuse();
    slot->clear();
    for (auto const& element : *list) {
      auto word = text(element);
      require(std::find(slot->begin(), slot->end(), word) == slot->end(), "a text of the list", word,
              "must stand there once");
      slot->push_back(std::move(word));
    }
  }
  void operator()(std::vector<std::int64_t>* slot) const {
    auto const* list = node.as_array();
    if (!list)
      refuse();
    slot->clear();
    for (auto const& element : *list) {
      auto const value = element.value_exact<std::int64_t>();
      if (!value || !key.range.contains(static_cast<double>(*value)))
        refuse();
      slot->push_back(*value);
    }
  }
  void operator()(TimeStep* slot) const {
    if (node.value_exact<std::string>() == "auto") {
      *slot = {.automatic = true};
      return;
    }
    *slot = node.is_number()          ? TimeStep{number(), true}
            : units == UnitSystem::SI ? TimeStep{quantity(), false}
                                      : TimeStep{lj_time(), false};
  }

  /// "0.05 tau"
  double lj_time() const {
    auto const written = text();
    double value = 0;
    auto const [end, error] = std::from_chars(written.data(), written.data() + written.size(), value);
    std::string_view const rest(end, written.data() + written.size());
    if (error != std::errc() || !key.range.contains(value) || (rest != " tau" && rest != "tau"))
      refuse();
    return value;
  }
};

toml::node const* find(toml::table const& scene, SceneKey const& key) {
  if (key.section.empty())
    return scene.get(key.name);
  auto const* section = scene.get_as<toml::table>(key.section);
  return section ? section->get(key.name) : nullptr;
}

} // namespace

Scene parse_scene(std::string const& text, std::filesystem::path const& file,
                  std::vector<std::string> const& overrides) {
  auto table = fitting::parse_toml(text, file.string());
  Places places(file.string());
  for (auto const& assignment : overrides)
    apply_override(table, assignment, places);
  refuse_unknown(table, places);
  Scene scene; // `units` and the method stand first in the table, before the keys that depend on them
  for (auto const& key : scene_keys()) {
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
      continue;
    if (auto const now = name_of_today(key, node->value_or(std::string())))
      scene.notes.push_back(fmt::format("{}: {} = {}: is called \"{}\" now", places.of(key.path()),
                                        key.path(), text_of(*node), *now));
    try {
      std::visit(SlotReader{*node, key, scene.units}, key.slot(scene));
    } catch (InputError const& error) {
      throw InputError(
          fmt::format("{}: {} = {}: {}", places.of(key.path()), key.path(), text_of(*node), error.what()));
    }
  }
  if (scene.features().densities)
    resolve_model_path(scene, file.parent_path(), places);
  resolve_pair_files(scene, file.parent_path(), places);
  check_together(scene, places);
  return scene;
}

std::string place_of(std::filesystem::path const& file, std::vector<std::string> const& overrides,
                     std::string const& key) {
  auto table = fitting::parse_toml(read_text_file(file), file.string());
  Places places(file.string());
  for (auto const& assignment : overrides)
    apply_override(table, assignment, places);
  if (auto const* node = table.at_path(key).node())
    places.note(key, node->source().begin.line);
  return places.of(key);
}

Scene load_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides) {
  return parse_scene(read_text_file(file), file, overrides);
}

} // namespace mesobridge::workflows
