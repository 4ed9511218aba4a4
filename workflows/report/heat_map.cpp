#include "workflows/report/heat_map.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/report/report.hpp"
#include "workflows/report/svg_parts.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace mesobridge::workflows {

namespace {

/// From white over the palette's blue to nearly black, so that the print shows it too.
std::string colour(double part) {
  part = std::clamp(part, 0.0, 1.0);
  auto const mix = [&](int light, int middle, int dark) {
    return part < 0.5 ? std::lround(light + 2 * part * (middle - light))
                      : std::lround(middle + (2 * part - 1) * (dark - middle));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(255, 0, 0), mix(255, 114, 20), mix(255, 178, 46));
}

} // namespace

std::string draw_svg(HeatMap const& map) {
  if (map.x.empty() || map.y.empty() || map.value.size() != map.x.size() * map.y.size())
    throw std::logic_error(fmt::format("heat map '{}': lengths differ", map.title));
  constexpr int left_margin = 72, right_margin = 96, top_margin = 36, bottom_margin = 56, scale_width = 16;
  double const wide = plot_width - left_margin - right_margin,
               high = plot_height - top_margin - bottom_margin;
  double const cell_x = wide / double(map.x.size()), cell_y = high / double(map.y.size());
  std::string svg =
      fmt::format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {} {}' role='img' "
                  "font-family='{}' font-size='{}'>\n<title>{}: {} over {} and {}</title>\n",
                  plot_width, plot_height, plot_font, plot_font_size, html_escaped(map.title),
                  html_escaped(map.value_label), html_escaped(map.x_label), html_escaped(map.y_label));
  svg += svg_text(left_margin + wide / 2, 20, "middle", map.title);
  for (std::size_t i = 0; i < map.x.size(); ++i)
    for (std::size_t j = 0; j < map.y.size(); ++j) {
      auto const& value = map.value[i * map.y.size() + j];
      svg += fmt::format("<rect x='{:.2f}' y='{:.2f}' width='{:.2f}' height='{:.2f}' fill='{}'/>\n",
                         left_margin + double(i) * cell_x, top_margin + high - double(j + 1) * cell_y,
                         cell_x + 0.3, cell_y + 0.3, value ? colour(*value / map.top) : "#c8ccd0");
    }
  svg += fmt::format("<rect x='{}' y='{}' width='{:.1f}' height='{:.1f}' fill='none' stroke='#1f2328'/>\n",
                     left_margin, top_margin, wide, high);
  for (std::size_t i = 0; i < map.x.size(); i += std::max<std::size_t>(1, map.x.size() / 5))
    svg += svg_text(left_margin + (double(i) + 0.5) * cell_x, top_margin + high + 18, "middle",
                    number_text(map.x[i], 3));
  for (std::size_t j = 0; j < map.y.size(); j += std::max<std::size_t>(1, map.y.size() / 5))
    svg += svg_text(left_margin - 6, top_margin + high - (double(j) + 0.5) * cell_y + 4, "end",
                    number_text(map.y[j], 3));
  svg += svg_text(left_margin + wide / 2, plot_height - 10, "middle", map.x_label);
  svg += svg_text(16, top_margin + high / 2, "middle", map.y_label,
                  fmt::format("transform='rotate(-90 16 {:.1f})'", top_margin + high / 2));
  constexpr int shades = 40;
  double const scale_x = left_margin + wide + 16;
  svg += svg_colour_bar(scale_x, top_margin, scale_width, high, shades, colour);
  svg += svg_text(scale_x + scale_width + 4, top_margin + high, "start", "0");
  svg += svg_text(scale_x + scale_width + 4, top_margin + 10, "start", number_text(map.top, 2));
  svg += svg_text(plot_width - 8, top_margin + high / 2, "middle", map.value_label,
                  fmt::format("transform='rotate(-90 {} {:.1f})'", plot_width - 8, top_margin + high / 2));
  return svg + "</svg>\n";
}

} // namespace mesobridge::workflows
