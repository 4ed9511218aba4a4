#include "workflows/coarse/plot_parts.hpp"

namespace mesobridge::workflows {

Series estimates(std::string label, std::vector<double> const& x, std::vector<cg::Estimate> const& y,
                 SeriesStyle style, int colour) {
  Series series{.label = std::move(label), .x = x, .style = style, .colour = colour};
  for (auto const& at : y)
    series.y.push_back(at.mean), series.y_error.push_back(at.se);
  return series;
}

} // namespace mesobridge::workflows
