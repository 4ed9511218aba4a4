#pragma once
#include "sdpd/method/dpd.hpp"
#include "sdpd/method/dpde.hpp"
#include "sdpd/method/sdpd.hpp"
#include <algorithm>
#include <type_traits>

namespace mesobridge::sdpd {

/// Every method; what asks for one asks the alternative, by std::visit.
using AnyMethod = std::variant<Sdpd, Dpde, Dpd>;

/// A method as scenes, options and texts speak of it.
struct NamedMethod {
  std::string_view name, title, help;
  Features features; ///< of its particles
  bool noise = true; ///< whether they fluctuate: a method may have a name of its own for when they do not
};

/// Every method: scenes, options and help take names and texts from here.
std::vector<NamedMethod> const& methods();

std::vector<std::string> method_names();

/// Throws InputError that lists the names.
NamedMethod const& method_named(std::string_view name);

/// Calls f(std::type_identity<Method>{}) for every method, in the list's order.
template <class F>
void for_each_method(F&& f) {
  [&]<class... Methods>(std::type_identity<std::variant<Methods...>>) {
    (f(std::type_identity<Methods>{}), ...);
  }(std::type_identity<AnyMethod>{});
}

/// What a method is called, with noise and, if it has a name for that, without.
template <class Method>
std::vector<std::string> names_of() {
  if constexpr (requires { Method::name_without_noise; })
    return {std::string(Method::name), std::string(Method::name_without_noise)};
  else
    return {std::string(Method::name)};
}

/// Calls f(std::type_identity<Method>{}) for the method of that name alone.
template <class F>
void for_method(std::string_view name, F&& f) {
  for_each_method([&]<class Method>(std::type_identity<Method> type) {
    if (auto const names = names_of<Method>(); std::ranges::find(names, name) != names.end())
      f(type);
  });
}

} // namespace mesobridge::sdpd
