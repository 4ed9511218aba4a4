#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// The numbers that a file may hold at one place: finite ones, if nothing else is said.
struct Bounds {
  double least = -std::numeric_limits<double>::infinity(); ///< included
  double above = -std::numeric_limits<double>::infinity(); ///< not included
  double most = std::numeric_limits<double>::infinity();   ///< included
  bool finite = true; ///< false: NaN and infinity are values, too (an empty cell, say)

  bool allows(double value) const {
    if (!std::isfinite(value))
      return !finite;
    return value >= least && value <= most && (value > above || std::isinf(above));
  }
  /// "a finite number > 0"
  std::string text() const;
};

/// What a dataset must be for its reader: checked before anything is allocated or indexed. The first extent
/// counts the rows, the others are the shape of one row.
struct Expected {
  using Shape = std::vector<std::size_t>;

  std::optional<std::size_t> rows{}; ///< exactly so many; if not given, any number from least_rows on
  std::size_t least_rows = 0;
  /// Shape{}: one number a row. If not given, rows of any shape; a single number if nothing else is said.
  std::optional<Shape> row_shape{};
  Bounds bounds{};
};

} // namespace mesobridge::workflows
