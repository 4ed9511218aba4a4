#include "sdpd/potential/list.hpp"
#include "workflows/scene/keys/parameter_line.hpp"
#include "workflows/scene/keys/tables.hpp"
#include <fmt/ranges.h>

// The keys of the pair potentials, as these describe themselves.

namespace mesobridge::workflows {
namespace {

SceneKey key_of_names() {
  std::vector<std::string> names, meanings;
  for (auto const& kind : sdpd::potentials()) {
    names.emplace_back(kind.name);
    meanings.push_back(kind.summary.empty() ? std::string(kind.name)
                                            : fmt::format("{}, {}", kind.name, kind.summary));
  }
  names.emplace_back("table"), meanings.emplace_back("table, a CSV file");
  names.emplace_back("model"),
      meanings.emplace_back("model, that of particles.model, which is usual if it has one");
  return Line(
             "potential", "name", [](Scene& s) { return &s.potential.name; },
             fmt::format("potential between two particles: {}", fmt::join(meanings, "; ")))
      .choices(names)
      .of<sdpd::Dpde, sdpd::Dpd>();
}

} // namespace

std::vector<sdpd::Parameter> potential_parameters() {
  return parameters_of(sdpd::potentials());
}

std::vector<SceneKey> potential_keys() {
  std::vector<SceneKey> keys{key_of_names()};
  for (auto const& parameter : potential_parameters())
    keys.push_back(parameter_line("potential", &Scene::potential, parameter, sdpd::potentials())
                       .of<sdpd::Dpde, sdpd::Dpd>());
  keys.push_back(Line(
                     "potential", "file", [](Scene& s) { return &s.potential.file; },
                     "CSV with columns r,u and perhaps the force f (SI: r_m,u_J,f_N); table")
                     .of<sdpd::Dpde, sdpd::Dpd>());
  return keys;
}

} // namespace mesobridge::workflows
