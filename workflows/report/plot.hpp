#pragma once
#include <optional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

enum class SeriesStyle { points, lines, dashes, steps, band };

/// One set of data in a plot. Labels are UTF-8 with gnuplot's marks: x^2, T_{kin}; `plain` takes the marks
/// out of a text.
struct Series {
  std::string label = {}; ///< empty: not in the legend
  std::vector<double> x = {}, y = {};
  std::vector<double> y_error =
      {}; ///< empty, or one standard error a point: error bars, or the half-width of a band
  SeriesStyle style = SeriesStyle::points;
  std::optional<int> colour =
      {}; ///< index into the palette; series of one colour belong together. Default: by position
};

struct Axis {
  std::string label; ///< quantity and unit: "P [GPa]"
  bool logarithmic = false;
  std::optional<double> min, max;
};

/// A legend stands under the drawing, where it covers no point.
enum class Legend { below, none };

/// Of every drawing [px]; drawings scale, so that equal sizes mean equal letters on a page.
inline constexpr int plot_width = 640, plot_height = 480, plot_font_size = 15;
inline constexpr char const* plot_font = "Arial";

/// One of the panels that stand on top of each other over a common x axis.
struct Panel {
  std::vector<Series> series;
  Axis y;
  double height = 1; ///< relative to the other panels
  Legend legend = Legend::below;
  std::vector<double> level_lines; ///< thin horizontal lines, e.g. {0} in a panel of residuals
};

struct Plot {
  std::string name = "plot"; ///< of its elements; letters and digits, unique in a report
  std::string title;
  Axis x;
  std::vector<Panel> panels;
};

/// A plot of one panel without data yet.
Plot one_panel(std::string name, std::string title, std::string x, std::string y,
               std::vector<double> level_lines = {});

/// Draws with gnuplot: an SVG element without XML prolog, ready to stand in HTML, of plot_width x
/// plot_height, with a text for those who cannot see it. Throws PhysicsError that names plot and series for
/// data that are not finite (or not positive on a logarithmic axis), std::logic_error for series of unequal
/// lengths, EnvironmentError with gnuplot's own words if it fails.
std::string draw_svg(Plot const& plot);

/// A text without gnuplot's marks: its underscores, carets and braces are shown as they are.
std::string plain(std::string const& text);

/// The fixed order of colours: distinguishable for colour-blind readers (Okabe and Ito).
std::vector<std::string> const& palette();

} // namespace mesobridge::workflows
