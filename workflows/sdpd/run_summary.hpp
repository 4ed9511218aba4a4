#pragma once
#include "sdpd/simulation.hpp"
#include "workflows/sdpd/run_file.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// What stands in summary.json of a finished run: the means of its samples with their standard errors, in the
/// scene's units. `calibration` is null unless the run found the constants of its densities itself.
Json run_summary(RunResult const& result, sdpd::Simulation const& simulation, RunFile const& file,
                 OutputUnits const& units, Json const& calibration);

} // namespace mesobridge::workflows
