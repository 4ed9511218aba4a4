#include "workflows/report/svg_parts.hpp"
#include "workflows/report/report.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {

std::string text_at(double x, double y, std::string const& anchor, std::string const& text,
                    std::string const& more) {
  return fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}' {}>{}</text>\n", x, y, anchor, more,
                     html_escaped(text));
}

std::string colour_bar(double x, double y, int width, double height, int shades,
                       std::function<std::string(double)> const& colour_of) {
  std::string svg;
  for (int k = 0; k < shades; ++k)
    svg += fmt::format("<rect x='{:.1f}' y='{:.2f}' width='{}' height='{:.2f}' fill='{}'/>\n", x,
                       y + height * (1 - (k + 1.0) / shades), width, height / shades + 0.3,
                       colour_of((k + 0.5) / shades));
  return svg;
}

} // namespace mesobridge::workflows
