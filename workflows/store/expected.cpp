#include "workflows/store/expected.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {

std::string Bounds::text() const {
  std::string range;
  auto const add = [&](bool given, char const* sign, double bound) {
    if (given)
      range += fmt::format("{} {} {}", range.empty() ? "" : " and", sign, bound);
  };
  add(!std::isinf(least), ">=", least);
  add(!std::isinf(above), ">", above);
  add(!std::isinf(most), "<=", most);
  return (finite ? "a finite number" : "a number") + range;
}

} // namespace mesobridge::workflows
