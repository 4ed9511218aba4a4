#include "sdpd/potential/list.hpp"
#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"
#include <algorithm>
#include <fmt/ranges.h>

// The keys of the pair potentials, as these describe themselves.

namespace mesobridge::workflows {
namespace {

std::string names_with(sdpd::Parameter const& parameter) {
  std::vector<std::string_view> names;
  for (auto const& kind : sdpd::potentials())
    if (std::ranges::find(kind.parameters, parameter.name, &sdpd::Parameter::name) != kind.parameters.end())
      names.push_back(kind.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

SceneKey key_of(sdpd::Parameter const& parameter) {
  SceneKey key = Line(
                     "potential", std::string(parameter.name),
                     [name = parameter.name](Scene& s) { return &s.potential.parameters[name]; },
                     fmt::format("{}; {}", parameter.meaning, names_with(parameter)))
                     .in(parameter.range)
                     .of<sdpd::Dpde, sdpd::Dpd>();
  key.dimension = parameter.dimension;
  return key;
}

SceneKey key_of_names() {
  std::vector<std::string> names, meanings;
  for (auto const& kind : sdpd::potentials()) {
    names.emplace_back(kind.name);
    meanings.push_back(kind.summary.empty() ? std::string(kind.name)
                                            : fmt::format("{}, {}", kind.name, kind.summary));
  }
  names.emplace_back("table"), meanings.emplace_back("table, a CSV file");
  return Line(
             "potential", "name", [](Scene& s) { return &s.potential.name; },
             fmt::format("potential between two particles: {}", fmt::join(meanings, "; ")))
      .choices(names)
      .of<sdpd::Dpde, sdpd::Dpd>();
}

} // namespace

/// In an order that keeps each potential's own: a new parameter stands before those of its potential that
/// are there already.
std::vector<sdpd::Parameter> potential_parameters() {
  std::vector<sdpd::Parameter> all;
  auto const place = [&](std::string_view name) {
    return std::ranges::find(all, name, &sdpd::Parameter::name);
  };
  for (auto const& kind : sdpd::potentials())
    for (std::size_t k = 0; k < kind.parameters.size(); ++k) {
      if (place(kind.parameters[k].name) != all.end())
        continue;
      auto before = all.end();
      for (std::size_t later = k + 1; later < kind.parameters.size(); ++later)
        before = std::min(before, place(kind.parameters[later].name));
      all.insert(before, kind.parameters[k]);
    }
  return all;
}

std::vector<SceneKey> potential_keys() {
  std::vector<SceneKey> keys{key_of_names()};
  for (auto const& parameter : potential_parameters())
    keys.push_back(key_of(parameter));
  keys.push_back(Line(
                     "potential", "file", [](Scene& s) { return &s.potential.file; },
                     "CSV with columns r,u and perhaps the force f (SI: r_m,u_J,f_N); table")
                     .of<sdpd::Dpde, sdpd::Dpd>());
  return keys;
}

} // namespace mesobridge::workflows
