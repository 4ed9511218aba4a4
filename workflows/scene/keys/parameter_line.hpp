#pragma once
#include "sdpd/state/parameter.hpp"
#include "workflows/scene/keys/line.hpp"
#include <algorithm>
#include <fmt/ranges.h>

namespace mesobridge::workflows {

/// The names of the laws that have a parameter.
template <class NamedLaw>
std::vector<std::string> names_with(std::vector<NamedLaw> const& laws, std::string_view parameter) {
  std::vector<std::string> names;
  for (auto const& law : laws)
    if (std::ranges::find(law.parameters, parameter, &sdpd::Parameter::name) != law.parameters.end())
      names.emplace_back(law.name);
  return names;
}

/// The key of a parameter of laws that describe themselves; its value lies in `parameters` of a part of the
/// scene.
template <class NamedLaw, class Part>
Line parameter_line(std::string section, Part Scene::*part, sdpd::Parameter const& parameter,
                    std::vector<NamedLaw> const& laws) {
  auto line = Line(
                  std::move(section), std::string(parameter.name),
                  [part, name = parameter.name](Scene& s) { return &(s.*part).parameters[name]; },
                  fmt::format("{}; {}", parameter.meaning, fmt::join(names_with(laws, parameter.name), ", ")))
                  .in(parameter.range);
  line.key.dimension = parameter.dimension;
  return line;
}

} // namespace mesobridge::workflows
