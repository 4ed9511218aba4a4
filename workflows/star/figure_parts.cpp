#include "workflows/star/figure_parts.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace mesobridge::workflows {

namespace {

constexpr int half_width = 480, half_height = 360;

} // namespace

Plot half_plot(std::string name, std::string title, std::string x, std::string y) {
  Plot plot{.name = std::move(name),
            .title = std::move(title),
            .x = {.label = std::move(x)},
            .panels = {Panel{}},
            .width = half_width,
            .height = half_height};
  plot.panels[0].y.label = std::move(y);
  return plot;
}

Series points_of(cg::Profile const& profile, std::string label, int colour) {
  Series series{.label = std::move(label), .x = profile.x, .y = {}, .y_error = {}, .colour = colour};
  for (auto const& y : profile.y) {
    series.y.push_back(y.mean);
    series.y_error.push_back(y.se);
  }
  return series;
}

Series curve_of(std::string label, SeriesStyle style, int colour) {
  return {.label = std::move(label), .x = {}, .y = {}, .y_error = {}, .style = style, .colour = colour};
}

void leave_room_for_legend(Panel& panel) {
  constexpr double room_at_least = 0.1, room_for_a_line = 0.15; // of the height of the data
  double room = room_at_least;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (auto const& series : panel.series) {
    room += series.label.empty() ? 0 : room_for_a_line;
    for (double const y : series.y)
      least = std::min(least, y), most = std::max(most, y);
  }
  if (least < most)
    panel.y.max = most + room * (most - least);
}

std::string density_label(ChapterMelt const& melt) {
  return fmt::format("rho = {}", melt.rho);
}

} // namespace mesobridge::workflows
