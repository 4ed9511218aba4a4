#pragma once
#include "workflows/report/plot.hpp"
#include <cstddef>

namespace mesobridge::workflows {

/// The datablock of a series: x, y and, if there are errors, the lower and the upper end of the bar.
std::string data_text(Series const& series, std::string const& name, bool logarithmic);

/// gnuplot's words that draw a datablock; `position` is that of the series in its panel.
std::string drawing_text(Series const& series, std::string const& data, std::size_t position);

/// What stands under the panels: the labels of all of them, in columns.
struct LegendBox {
  std::vector<std::string> entries; ///< gnuplot's words
  std::size_t rows = 0;
  static constexpr double row_height = 22; ///< [px]
  double height() const { return rows == 0 ? 0 : 16 + row_height * static_cast<double>(rows); }
};

LegendBox legend_of(Plot const& plot);

} // namespace mesobridge::workflows
