#pragma once
#include <fmt/format.h>
#include <sstream>
#include <string>

namespace mesobridge::workflows {

/// Calls f(line, path, value) for each line of a resolved scene: path is "section.key" or "region.1.key", the
/// value as it stands there; both are empty where the line has no key.
template <class F>
void for_each_resolved_line(std::string const& resolved, F const& f) {
  std::istringstream lines(resolved);
  std::string section;
  int regions = 0;
  for (std::string line; std::getline(lines, line);) {
    auto const equals = line.find(" = ");
    if (line == "[[region]]")
      section = fmt::format("region.{}.", ++regions);
    else if (line.starts_with('['))
      section = line.substr(1, line.find(']') - 1) + ".";
    else if (equals != line.npos) {
      f(line, section + line.substr(0, equals), line.substr(equals + 3));
      continue;
    }
    f(line, std::string(), std::string());
  }
}

} // namespace mesobridge::workflows
