#pragma once
#include "workflows/beside/run_numbers.hpp"
#include "workflows/report/plot.hpp"

namespace mesobridge::workflows {

/// Temperatures, pressure and density of the runs that have them in their run.h5, over time: one drawing a
/// quantity, one line a run. Throws InputError for a run.h5 that is damaged.
std::vector<Plot> series_beside(std::vector<RunNumbers> const& runs);

} // namespace mesobridge::workflows
