#pragma once
#include "sdpd/calibrate_density.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// Whether the constants of the densities are still to be found.
bool wants_calibration(Scene const& scene);

/// What fixes the scale in a calibration of this scene.
sdpd::ScaleCondition scale_condition_of(Scene const& scene);

/// Finds them on the scene's own fluid. Throws as calibrate_density.
sdpd::DensityCalibration calibrate(Scene const& scene, int threads, std::function<bool()> const& keep_going);

/// The constants with their standard errors and the last stage's density and pressure in the scene's units.
Json calibration_json(sdpd::DensityCalibration const& calibration, OutputUnits const& units);

} // namespace mesobridge::workflows
