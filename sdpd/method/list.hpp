#pragma once
#include "sdpd/method/dpd.hpp"
#include "sdpd/method/dpde.hpp"
#include "sdpd/method/sdpd.hpp"
#include <type_traits>

namespace mesobridge::sdpd {

/// Every method; what asks for one asks the alternative, by std::visit.
using AnyMethod = std::variant<Sdpd, Dpde, Dpd>;

/// A method as scenes, options and texts speak of it.
struct NamedMethod {
  std::string_view name, title, help;
  Features features; ///< of its particles
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

/// The same for the method of that name alone.
template <class F>
void for_method(std::string_view name, F&& f) {
  for_each_method([&]<class Method>(std::type_identity<Method> type) {
    if (Method::name == name)
      f(type);
  });
}

} // namespace mesobridge::sdpd
