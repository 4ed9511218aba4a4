#pragma once
#include "workflows/report/plot.hpp"

namespace mesobridge::workflows {

/// A quantity over two axes, shown by colours: values[k] is a row along x at y[k]. What is not finite stays
/// white.
struct ColourMap {
  std::string name = "map"; ///< of its elements; letters and digits, unique in a report
  std::string title, x_label, y_label, colour_label;
  std::vector<double> x, y; ///< equally spaced, two each at least
  std::vector<std::vector<double>> values;
};

/// Draws with gnuplot, as draw_svg(Plot). Throws std::logic_error for sizes that do not belong together,
/// PhysicsError where no value is finite, EnvironmentError with gnuplot's own words if it fails.
std::string draw_svg(ColourMap const& map);

} // namespace mesobridge::workflows
