#pragma once
#include "workflows/star/sample_melt.hpp"
#include "workflows/star/sample_vacuum.hpp"

namespace mesobridge::workflows {

/// Makes those of the runs that are not there yet; an interrupted one goes on from its checkpoint. Each gets
/// its folder. They are independent: where that is faster for all of them together, each takes one core and
/// several go on at once. Throws InputError where a folder holds another run, and as farm and the runs
/// themselves.
void make_runs(std::vector<MeltJob> const& melts, std::vector<VacuumJob> const& vacuums,
               Context const& context);

} // namespace mesobridge::workflows
