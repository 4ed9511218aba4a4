#include "workflows/scene/keys.hpp"
#include <fmt/ranges.h>
#include <sstream>
#include <toml++/toml.h>

namespace mesobridge::workflows {
namespace {

std::string quoted(std::string const& text) {
  std::ostringstream out;
  out << toml::toml_formatter(toml::value<std::string>(text), toml::format_flags::none); // in double quotes
  return out.str();
}

} // namespace

std::optional<std::string> value_text(SceneKey const& key, Scene const& scene) {
  if (!key.belongs_to(scene.method.name))
    return std::nullopt;
  struct Writer {
    SceneKey const& key;
    bool si;
    using Text = std::optional<std::string>;
    std::string number(double value) const {
      return key.dimension && si ? quoted(quantity_text(value, *key.dimension)) : fmt::format("{}", value);
    }
    Text operator()(std::string const* text) const { return quoted(*text); }
    Text operator()(std::optional<std::string> const* text) const {
      return *text ? Text(quoted(**text)) : Text();
    }
    Text operator()(std::int64_t const* value) const { return fmt::format("{}", *value); }
    Text operator()(double const* value) const { return number(*value); }
    Text operator()(std::optional<double> const* value) const {
      return *value ? Text(number(**value)) : Text();
    }
    Text operator()(std::vector<std::string> const* texts) const {
      std::vector<std::string> words;
      for (auto const& text : *texts)
        words.push_back(quoted(text));
      return fmt::format("[{}]", fmt::join(words, ", "));
    }
    Text operator()(std::vector<std::int64_t> const* numbers) const {
      return numbers->empty() ? Text() : fmt::format("[{}]", fmt::join(*numbers, ", "));
    }
    Text operator()(std::vector<double> const* numbers) const {
      std::vector<std::string> words;
      for (double const value : *numbers)
        words.push_back(number(value));
      return words.empty() ? Text() : fmt::format("[{}]", fmt::join(words, ", "));
    }
    Text operator()(std::vector<Coordinate> const* places) const {
      std::vector<std::string> words;
      for (auto const& [value, is_share] : *places)
        words.push_back(is_share ? fmt::format("\"{} %\"", value) : number(value));
      return words.empty() ? Text() : fmt::format("[{}]", fmt::join(words, ", "));
    }
    Text operator()(TimeStep const* dt) const {
      if (dt->automatic)
        return "\"auto\"";
      if (dt->reduced)
        return fmt::format("{}", dt->value);
      return si ? number(dt->value) : fmt::format("\"{} tau\"", dt->value);
    }
    Text operator()(UnitSystem const* units) const { return *units == UnitSystem::SI ? "\"SI\"" : "\"lj\""; }
  };
  auto copy = scene; // slots point into a scene that may be written to
  return std::visit(Writer{key, scene.units == UnitSystem::SI}, key.slot(copy));
}

std::string resolved_toml(Scene const& scene) {
  std::string text, table;
  for (auto const& key : all_keys(scene)) {
    auto const value = value_text(key, scene);
    if (!value || (key.written && !key.written(scene)))
      continue;
    if (auto const of_key = key.path().substr(0, key.path().rfind('.'));
        of_key != table && !key.section.empty()) {
      table = of_key;
      text += key.number ? "\n[[" + key.section + "]]\n" : "\n[" + key.section + "]\n";
    }
    text += key.name + " = " + *value + "\n";
  }
  return text;
}

std::string scene_keys_text() {
  std::string text = "Keys of a scene (* must be given):\n", section;
  Scene one_region;
  one_region.regions.resize(1);
  for (auto const& key : all_keys(one_region)) {
    if (key.section != section) {
      section = key.section;
      text += key.number ? "\n[[" + section + "]] (any number of them; each takes from those before it)\n"
                         : "\n[" + section + "]\n";
    }
    text += fmt::format("{}{:<17} {}\n", key.required ? '*' : ' ', key.name, key.meaning);
    text += fmt::format("{:<19}{}", "", key.allowed(UnitSystem::SI));
    Scene fresh;
    if (!key.methods.empty())
      fresh.method.name = key.methods.front();
    auto const value = key.required ? std::nullopt : value_text(key, fresh);
    if (!key.methods.empty())
      text += fmt::format("; for {}", fmt::join(key.methods, ", "));
    text += (value ? "; default " + *value : "") + "\n";
  }
  return text;
}

} // namespace mesobridge::workflows
