#include "workflows/report/drawn.hpp"

namespace mesobridge::workflows {

Figure drawn(std::vector<Plot> const& plots, std::string caption) {
  Figure figure{{}, std::move(caption)};
  for (auto const& plot : plots)
    if (!plot.panels[0].series.empty())
      figure.svgs.push_back(draw_svg(plot));
  return figure;
}

} // namespace mesobridge::workflows
