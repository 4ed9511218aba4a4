#pragma once
#include "workflows/report/plot.hpp"

namespace mesobridge::workflows {

/// A text in gnuplot's quotes.
std::string escaped(std::string const& text);

/// The x axis of all panels, with room for all their data.
Axis common_x_axis(Plot const& plot);

/// gnuplot's own choice ends at marks, which suits linear axes; a logarithmic one would end at its outermost
/// points or a decade beyond them.
Axis y_axis(Panel const& panel);

/// gnuplot's words for an axis, `which` is x or y: label, range, marks.
std::string axis_text(char which, Axis const& axis);

/// Fewer marks for panels of a low height [px], whose numbers would run into each other.
std::string marks_of_low_panel(Panel const& panel, double height);

} // namespace mesobridge::workflows
