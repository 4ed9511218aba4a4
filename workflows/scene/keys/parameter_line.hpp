#pragma once
#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"
#include <fmt/ranges.h>

namespace mesobridge::workflows {

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
