#include "workflows/coarse/plot_parts.hpp"

namespace mesobridge::workflows {

Series estimates(std::string label, std::vector<double> const& x, std::vector<cg::Estimate> const& y,
                 SeriesStyle style, int colour) {
  Series series{.label = std::move(label), .x = x, .y = {}, .y_error = {}, .style = style, .colour = colour};
  for (auto const& at : y)
    series.y.push_back(at.mean), series.y_error.push_back(at.se);
  return series;
}

Plot one_panel(std::string name, std::string title, std::string x, std::string y) {
  Plot plot{
      .name = std::move(name), .title = std::move(title), .x = {.label = std::move(x)}, .panels = {Panel{}}};
  plot.panels[0].y.label = std::move(y);
  plot.panels[0].level_lines = {0};
  return plot;
}

} // namespace mesobridge::workflows
