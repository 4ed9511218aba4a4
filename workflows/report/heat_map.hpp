#pragma once
#include <optional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// A grid of coloured cells with a scale, as an SVG element of the size of all plots.
struct HeatMap {
  std::string title, x_label, y_label, value_label;
  std::vector<double> x, y;                 ///< centres of the cells, at equal distances
  std::vector<std::optional<double>> value; ///< number x * y.size() + y; none: grey
  double top = 1;                           ///< the value of the darkest colour; larger ones have it too
};

std::string draw_svg(HeatMap const& map);

} // namespace mesobridge::workflows
