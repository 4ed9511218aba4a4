#pragma once
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// The commands of star polymers and their blobs.
Command md_star_melt_command();
Command md_star_vacuum_command();
Command cg_blobs_command();
Command cg_correlations_command();
Command cg_entropy_command();
Command fit_dpde_command();
Command workflow_star_polymers_command();
Command bench_blobs_command();

} // namespace mesobridge::workflows
