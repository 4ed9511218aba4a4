#pragma once
#include "workflows/report/plot.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// A figure of the plots side by side; one without any series is left out. Throws as draw_svg.
Figure drawn(std::vector<Plot> const& plots, std::string caption);

} // namespace mesobridge::workflows
