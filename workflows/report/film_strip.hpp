#pragma once
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// Points of some instants, coloured by a quantity, one picture under the other or side by side with one
/// scale.
struct FilmStrip {
  struct Frame {
    std::string title; ///< "t = 1.2 ps"
    std::vector<double> x, y, value;
  };
  std::string name = "film"; ///< of its elements; letters and digits, unique in a report
  std::string title, x_label, y_label, value_label;
  double x_from = 0, x_to = 1, y_from = 0, y_to = 1; ///< points outside are not drawn
  double value_from = 0, value_to = 1; ///< the ends of the colours, which values beyond have too
  double point_size = 0.01;            ///< diameter, in the unit of x and y
  std::vector<Frame> frames;
};

/// An SVG element of its own, without gnuplot, for thousands of points a frame. Throws std::logic_error for
/// frames whose lengths differ, and where there is none.
std::string draw_svg(FilmStrip const& strip);

/// Draws one frame with gnuplot into a PNG file. Throws EnvironmentError with gnuplot's own words if it
/// fails.
void draw_png(FilmStrip const& strip, std::size_t frame, std::string const& file);

/// A label's powers as letters: "kg/m^3" is "kg/m³".
std::string with_raised_numbers(std::string label);

} // namespace mesobridge::workflows
