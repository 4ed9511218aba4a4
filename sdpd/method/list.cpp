#include "sdpd/method/list.hpp"
#include <algorithm>
#include <fmt/ranges.h>

namespace mesobridge::sdpd {

std::vector<NamedMethod> const& methods() {
  static auto const list = [] {
    std::vector<NamedMethod> all;
    for_each_method([&]<class Method>(std::type_identity<Method>) {
      all.push_back({Method::name, Method::title, Method::help, Method::features});
      if constexpr (requires { Method::name_without_noise; })
        all.push_back({Method::name_without_noise, Method::title_without_noise, Method::help_without_noise,
                       Method::features, false});
    });
    return all;
  }();
  return list;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (auto const& method : methods())
    names.emplace_back(method.name);
  return names;
}

NamedMethod const& method_named(std::string_view name) {
  auto const found = std::ranges::find(methods(), name, &NamedMethod::name);
  if (found == methods().end())
    throw InputError(fmt::format("method = '{}': must be one of {}", name, fmt::join(method_names(), ", ")));
  return *found;
}

} // namespace mesobridge::sdpd
