#pragma once
#include "md/dimension.hpp"
#include "md/number_range.hpp"
#include <optional>
#include <string_view>

namespace mesobridge::sdpd {

/// A number that a law is made of, declared once: scenes read it, messages refuse it and tests draw it by
/// this.
struct Parameter {
  std::string_view name;
  std::optional<Dimension> dimension; ///< none: a pure number
  std::string_view meaning;           ///< a few words
  NumberRange range;

  /// Throws InputError that names the law, the parameter and what is allowed.
  void check(std::string_view law, double value) const {
    require(range.contains(value), fmt::format("{} {}", law, name), value, range.demand());
  }
};

} // namespace mesobridge::sdpd
