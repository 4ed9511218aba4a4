#pragma once
#include "fitting/fit_eos.hpp"
#include "workflows/report/plot.hpp"

namespace mesobridge::workflows {

/// One plot for each kind of observation and each quantity that was measured in it: data, fit with its
/// uncertainty (two standard errors), and below the deviations in standard errors.
std::vector<Plot> eos_fit_figures(fitting::EosFit const& fit);

} // namespace mesobridge::workflows
