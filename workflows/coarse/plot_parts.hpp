#pragma once
#include "cg/estimate.hpp"
#include "workflows/report/plot.hpp"

namespace mesobridge::workflows {

/// Values with their standard errors.
Series estimates(std::string label, std::vector<double> const& x, std::vector<cg::Estimate> const& y,
                 SeriesStyle style, int colour);

/// Without its series yet; a line at zero.
Plot one_panel(std::string name, std::string title, std::string x, std::string y);

} // namespace mesobridge::workflows
