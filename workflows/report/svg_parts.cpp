#include "workflows/report/svg_parts.hpp"
#include "workflows/report/report.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {

std::string svg_text(double x, double y, std::string const& anchor, std::string const& text,
                     std::string const& more) {
  return fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}' {}>{}</text>\n", x, y, anchor, more,
                     html_escaped(text));
}

std::string svg_colour_bar(double x, double y, double width, double height, int shades,
                           std::function<std::string(double)> const& colour) {
  constexpr double overlap = 0.3; // no light between neighbours
  std::string svg;
  for (int k = 0; k < shades; ++k)
    svg += fmt::format("<rect x='{:.1f}' y='{:.2f}' width='{}' height='{:.2f}' fill='{}'/>\n", x,
                       y + height * (1 - (k + 1.0) / shades), width, height / shades + overlap,
                       colour((k + 0.5) / shades));
  return svg;
}

} // namespace mesobridge::workflows
