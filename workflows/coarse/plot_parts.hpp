#pragma once
#include "cg/estimate.hpp"
#include "workflows/report/plot.hpp"

namespace mesobridge::workflows {

/// Values with their standard errors.
Series estimates(std::string label, std::vector<double> const& x, std::vector<cg::Estimate> const& y,
                 SeriesStyle style, int colour);

} // namespace mesobridge::workflows
