#pragma once
#include "scene_error.hpp"
#include "sdpd/state/parameter.hpp"
#include "workflows/sdpd/settings.hpp"
#include <fmt/ranges.h>

namespace mesobridge::tests {

/// A law that scenes choose by its name, with the lines of its own keys.
struct LawKeys {
  std::string key; ///< "table.name" of what it is chosen by; its own keys are in the same table
  std::string_view name;
  std::vector<sdpd::Parameter> parameters;
  std::vector<std::string> lines; ///< one a parameter

  /// line(parameter) gives a parameter a value.
  template <class Law, class Line>
  LawKeys(std::string of, Law const& law, Line const& line)
      : key(std::move(of)), name(law.name), parameters(law.parameters) {
    for (auto const& parameter : parameters)
      lines.push_back(line(parameter));
  }
  std::string table() const { return key.substr(0, key.find('.')); }
  /// The lines that choose the law with these keys of its own.
  std::string chosen(std::vector<std::string> const& own) const {
    return fmt::format("{} = \"{}\"\n{}", key.substr(key.find('.') + 1), name, fmt::join(own, ""));
  }
};

/// In the place of `usual`, the lines of the scene's own law, a law's keys make a scene that reads back as
/// the same, and none may be missing. Returns how many were left out.
inline int expect_all_keys_needed(std::string const& text, std::string const& usual, LawKeys const& law) {
  auto const scene = workflows::parse_scene(replaced(text, usual, law.chosen(law.lines)), "scene.toml");
  EXPECT_TRUE(workflows::parse_scene(resolved_toml(scene), "resolved.toml") == scene) << law.name;
  EXPECT_NO_THROW(sdpd::check(settings_of(scene, 1))) << law.name;
  int missing = 0;
  for (auto const& parameter : law.parameters) {
    auto some = law.lines;
    some.erase(some.begin() + missing++);
    auto const error = error_of(replaced(text, usual, law.chosen(some)));
    EXPECT_NE(error.find(fmt::format("{}.{}' is missing", law.table(), parameter.name)), std::string::npos)
        << error;
  }
  return missing;
}

/// The keys of a law with one more, of another law, are refused.
inline void expect_foreign_key(std::string const& text, std::string const& usual, LawKeys const& law,
                               std::string const& line) {
  auto more = law.lines;
  more.push_back(line);
  auto const error = error_of(replaced(text, usual, law.chosen(more)));
  EXPECT_NE(error.find("belongs to " + law.key), std::string::npos) << error;
}

} // namespace mesobridge::tests
