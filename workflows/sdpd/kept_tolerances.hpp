#pragma once
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {

/// By which share the run's time step makes self-diffusion too large at most (sdpd/README.md, Eq. (S92)).
double diffusion_excess_at_most(RunResult const& result);

/// What a finished run has kept of the tolerances that its time step was chosen for: of each what was wanted
/// and found, with its standard error, and whether it is fulfilled, as far as two standard errors tell.
/// Errors of temperatures do not count what the time step has added to the energy, which is no excuse. Null
/// where dt was given.
Json kept_tolerances(RunResult const& result);

} // namespace mesobridge::workflows
