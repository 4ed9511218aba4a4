#include "sdpd/potential/list.hpp"

namespace mesobridge::sdpd {
namespace {

template <class Potential>
void append_kinds(std::vector<NamedPotential>& all) {
  if constexpr (requires { Potential::kinds(); })
    for (auto const& kind : Potential::kinds())
      all.push_back({kind.name, kind.summary, kind.parameters, kind.make});
}

template <class... Potentials>
std::vector<NamedPotential> kinds_of(std::variant<Potentials...> const*) {
  std::vector<NamedPotential> all;
  (append_kinds<Potentials>(all), ...);
  return all;
}

} // namespace

std::vector<NamedPotential> const& potentials() {
  static auto const all = kinds_of(static_cast<AnyPotential const*>(nullptr));
  return all;
}

} // namespace mesobridge::sdpd
