#include "fitting/toml_reader.hpp"
#include "fitting/toml_depth.hpp"
#include <algorithm>

namespace mesobridge::fitting {

TomlReader::TomlReader(toml::table const& table, std::string file, std::string path)
    : table_(table), file_(std::move(file)), path_(std::move(path)) {}

void TomlReader::refuse(toml::node const& node, std::string_view key,
                        std::string_view what_is_allowed) const {
  throw InputError(
      fmt::format("{}:{}: {}{}: {}", file_, node.source().begin.line, path_, key, what_is_allowed));
}

toml::node const& TomlReader::node(std::string_view key, std::string_view what_is_allowed) {
  known_.emplace_back(key);
  toml::node const* const found = table_.get(key);
  if (!found)
    refuse(table_, key, fmt::format("missing; {}", what_is_allowed));
  return *found;
}

double TomlReader::finite(toml::node const& node, std::string_view key) const {
  auto const value = node.value<double>(); // integers too
  if (!node.is_number() || !value || !std::isfinite(*value))
    refuse(node, key, "must be a finite number");
  return *value;
}

double TomlReader::number(std::string_view key) {
  return finite(node(key, "must be a finite number"), key);
}

std::vector<double> TomlReader::numbers(std::string_view key, std::size_t count) {
  auto const allowed = fmt::format("must be an array of {} finite numbers", count);
  auto const& found = node(key, allowed);
  auto const* const array = found.as_array();
  if (!array || array->size() != count)
    refuse(found, key, allowed);
  std::vector<double> values;
  for (auto const& entry : *array)
    values.push_back(finite(entry, key));
  return values;
}

std::string TomlReader::text(std::string_view key) {
  auto const& found = node(key, "must be a string");
  if (!found.is_string())
    refuse(found, key, "must be a string");
  return *found.value<std::string>();
}

std::vector<std::string> TomlReader::names(std::string_view key, std::vector<std::string> const& allowed) {
  auto const what = fmt::format("must be an array of different names out of: {}", fmt::join(allowed, ", "));
  auto const& found = node(key, what);
  auto const* const array = found.as_array();
  if (!array)
    refuse(found, key, what);
  std::vector<std::string> names;
  for (auto const& entry : *array) {
    auto const name = entry.value<std::string>();
    if (!name || std::ranges::find(allowed, *name) == allowed.end() ||
        std::ranges::find(names, *name) != names.end())
      refuse(entry, key, what);
    names.push_back(*name);
  }
  return names;
}

TomlReader TomlReader::table(std::string_view key) {
  auto const& found = node(key, "must be a table");
  if (!found.is_table())
    refuse(found, key, "must be a table");
  return TomlReader(*found.as_table(), file_, fmt::format("{}{}.", path_, key));
}

std::vector<std::pair<std::string, std::string>> TomlReader::texts() {
  std::vector<std::pair<std::string, std::string>> all;
  for (auto const& [key, value] : table_)
    all.emplace_back(std::string(key.str()), text(key.str()));
  return all;
}

void TomlReader::refuse_unknown() const {
  for (auto const& [key, value] : table_)
    if (std::ranges::find(known_, key.str()) == known_.end())
      refuse(value, key.str(), fmt::format("unknown key; known here: {}", fmt::join(known_, ", ")));
}

toml::table parse_toml(std::string_view text, std::string const& file) {
  refuse_deep_toml(text, file);
  try {
    return toml::parse(text, file);
  } catch (toml::parse_error const& error) {
    throw InputError(fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
  }
}

} // namespace mesobridge::fitting
