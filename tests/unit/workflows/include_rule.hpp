#pragma once
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace mesobridge::tests {

inline std::filesystem::path const source{MESOBRIDGE_SOURCE_DIR};

/// The stages of the pipeline from the source to the mouth; the tests come after all of them.
inline std::array<std::string, 6> const pipeline{"md", "cg", "fitting", "sdpd", "workflows", "tests"};
inline std::array<std::string, 5> const stages{"md", "cg", "fitting", "sdpd", "workflows"};

/// The includes in the text of a file of one stage that point downstream.
inline std::vector<std::string> offences(std::string const& stage, std::string const& text) {
  static std::regex const include(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
  auto const rank = [](std::string const& name) { return std::find(pipeline.begin(), pipeline.end(), name); };
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_search(line, match, include))
      continue;
    for (auto const& part : std::filesystem::path(match[1].str()))
      if (rank(part) != pipeline.end() && rank(part) > rank(stage)) {
        found.push_back(match[1]);
        break;
      }
  }
  return found;
}

inline std::string read(std::filesystem::path const& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Calls f(path, text) for every C++ file of a stage.
template <class F>
void for_each_source(std::string const& stage, F const& f) {
  for (auto const& entry : std::filesystem::recursive_directory_iterator(source / stage))
    if (auto const extension = entry.path().extension(); extension == ".hpp" || extension == ".cpp")
      f(entry.path(), read(entry.path()));
}

} // namespace mesobridge::tests
