#pragma once
#include "md/error.hpp"
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace mesobridge::sdpd {

/// A number that a law is made of, declared once: scenes read it, messages refuse it and tests draw it by
/// this.
struct Parameter {
  enum class Unit { none, length, energy, force };

  std::string_view name;
  Unit unit = Unit::none;
  std::string_view meaning; ///< a few words
  double min = 0;
  bool above = false; ///< min itself is not allowed
  double max = std::numeric_limits<double>::infinity();

  bool allows(double value) const {
    return std::isfinite(value) && value <= max && (above ? value > min : value >= min);
  }
  std::string bounds() const {
    auto const below = std::isfinite(max) ? fmt::format(" and <= {:g}", max) : " and finite";
    return fmt::format("must be {} {:g}{}", above ? ">" : ">=", min, below);
  }
  /// Throws InputError that names the law, the parameter and what is allowed.
  void check(std::string_view law, double value) const {
    require(allows(value), fmt::format("{} {}", law, name), value, bounds());
  }
};

} // namespace mesobridge::sdpd
