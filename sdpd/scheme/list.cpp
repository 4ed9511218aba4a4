#include "sdpd/scheme/list.hpp"
#include "md/error.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include <fmt/ranges.h>

namespace mesobridge::sdpd {
namespace {

template <class Named>
std::vector<std::string> names_of(std::vector<Named> const& list) {
  std::vector<std::string> names;
  for (auto const& known : list)
    names.push_back(known.name);
  return names;
}

template <class Named>
Named const& find(std::vector<Named> const& list, std::string_view what, std::string_view name) {
  for (auto const& known : list)
    if (known.name == name)
      return known;
  throw InputError(fmt::format("{} = '{}': must be one of {}", what, name, fmt::join(names_of(list), ", ")));
}

} // namespace

std::vector<NamedPairScheme> const& pair_schemes() {
  static std::vector<NamedPairScheme> const list{
      {"ssa", PairScheme::ssa, "every step of a pair is made"},
      {"ams", PairScheme::ams, "not made when an energy would leave the equation of state"},
      {"ems", PairScheme::ems, "put to a Metropolis test too, which makes it exact at any time step"},
      {"ser", PairScheme::ser, "all pairs at once, for short time steps"},
      {"ser-implicit", PairScheme::ser_implicit, "all pairs at once, implicitly"},
      {"hybrid", PairScheme::hybrid, "ssa within eight domains and ser between them"},
      {"entropy", PairScheme::entropy, "the original form of SDPD, which heats unless steps are tiny"},
  };
  return list;
}

std::vector<std::string> pair_scheme_names() {
  return names_of(pair_schemes());
}

PairScheme pair_scheme(std::string_view name) {
  return find(pair_schemes(), "scheme", name).scheme;
}

std::vector<NamedConservative> const& conservative_integrators() {
  static std::vector<NamedConservative> const list{
      {"verlet", Conservative::verlet, "one evaluation of the forces a step"},
      {"two-stage", Conservative::two_stage, "two evaluations, a far smaller energy error"},
      {"none", Conservative::none, "particles stay in place, fluctuation and dissipation alone"},
  };
  return list;
}

std::vector<std::string> conservative_names() {
  return names_of(conservative_integrators());
}

Conservative conservative_integrator(std::string_view name) {
  return find(conservative_integrators(), "conservative", name).integrator;
}

} // namespace mesobridge::sdpd
