#pragma once
#include <functional>
#include <string>

namespace mesobridge::workflows {

/// A text of an SVG drawing; `anchor` is start, middle or end, `more` further attributes.
std::string svg_text(double x, double y, std::string const& anchor, std::string const& text,
                     std::string const& more = "");

/// A bar of so many shades whose upper left corner is at (x, y): the colour of the share 0 at the bottom, of
/// 1 at the top.
std::string svg_colour_bar(double x, double y, double width, double height, int shades,
                           std::function<std::string(double)> const& colour);

} // namespace mesobridge::workflows
