#include "workflows/star/figure_parts.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {

Plot framed_plot(std::string name, std::string title, std::string x, std::string y) {
  auto plot = one_panel(std::move(name), std::move(title), std::move(x), std::move(y));
  return plot;
}

Series points_of(cg::Profile const& profile, std::string label, int colour) {
  Series series{.label = std::move(label), .x = profile.x, .colour = colour};
  for (auto const& y : profile.y) {
    series.y.push_back(y.mean);
    series.y_error.push_back(y.se);
  }
  return series;
}

Series curve_of(std::string label, SeriesStyle style, int colour) {
  return {.label = std::move(label), .x = {}, .y = {}, .y_error = {}, .style = style, .colour = colour};
}

std::string density_label(ChapterMelt const& melt) {
  return fmt::format("rho = {}", melt.rho);
}

} // namespace mesobridge::workflows
