#pragma once
#include "md/error.hpp"
#include <cmath>
#include <limits>
#include <string>

namespace mesobridge {

/// The values that a number may have: finite ones from min (itself excluded if `open`) to max.
struct NumberRange {
  double min = -std::numeric_limits<double>::infinity();
  bool open = false;
  double max = std::numeric_limits<double>::infinity();

  bool contains(double value) const {
    return std::isfinite(value) && (open ? value > min : value >= min) && value <= max;
  }
  /// "> 0", "from 1 to 10", "> 7 and <= 100"; nothing where all finite numbers are allowed.
  std::string text() const {
    bool const below = std::isfinite(min), above = std::isfinite(max);
    if (below && above)
      return open ? fmt::format("> {} and <= {}", min, max) : fmt::format("from {} to {}", min, max);
    if (below)
      return fmt::format("{} {}", open ? ">" : ">=", min);
    return above ? fmt::format("<= {}", max) : "";
  }
  /// For messages: "must be > 0 and finite".
  std::string demand() const {
    auto const limits = text();
    if (limits.empty())
      return "must be finite";
    return "must be " + limits + (std::isfinite(max) ? "" : " and finite");
  }
};

inline constexpr NumberRange positive{.min = 0, .open = true}, not_negative{.min = 0}, any_number{};

} // namespace mesobridge
