#include "sdpd/kinetics/list.hpp"
#include <algorithm>
#include <fmt/ranges.h>

namespace mesobridge::sdpd {
namespace {

template <class... Laws>
std::vector<NamedKinetics> kinds_of(std::variant<Laws...> const*) {
  std::vector<NamedKinetics> all;
  auto const append = [&](auto const& kinds) {
    for (auto const& kind : kinds)
      all.push_back({kind.name, kind.summary, kind.parameters, [kind](std::span<double const> values) {
                       for (std::size_t k = 0; k < values.size(); ++k)
                         kind.parameters[k].check(kind.name, values[k]);
                       return AnyKinetics(kind.make(values));
                     }});
  };
  (append(Laws::kinds()), ...);
  return all;
}

} // namespace

std::vector<NamedKinetics> const& kinetics() {
  static auto const all = kinds_of(static_cast<AnyKinetics const*>(nullptr));
  return all;
}

NamedKinetics const& kinetics_named(std::string_view name) {
  auto const found = std::ranges::find(kinetics(), name, &NamedKinetics::name);
  if (found != kinetics().end())
    return *found;
  std::vector<std::string_view> names;
  for (auto const& law : kinetics())
    names.push_back(law.name);
  throw InputError(fmt::format("kinetics = '{}': must be one of {}", name, fmt::join(names, ", ")));
}

std::vector<std::string> rate_integrator_names() {
  return {"euler", "midpoint"};
}

} // namespace mesobridge::sdpd
