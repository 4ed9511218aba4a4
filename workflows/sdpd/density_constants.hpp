#pragma once
#include "sdpd/setup/calibrate_density.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// Whether the constants of the densities are still to be found.
bool wants_calibration(Scene const& scene);

/// [fluid] without the regions in it, unburnt, by which all densities are calibrated.
Scene fluid_alone(Scene scene);

/// What fixes the scale in the calibration that this scene wants.
sdpd::ScaleCondition scale_condition_of(Scene const& scene);

/// Steps that finding them takes: what the scene says or, if it leaves that open, a quarter of the run's, 200
/// ... 6000.
std::int64_t calibration_steps(Scene const& scene);

/// The settings of the fluid that they are found on: that of [fluid] without the scene's regions, in the
/// state that the scene wants them for, with the same particles, kernels and time step. Throws InputError
/// when that is the state behind a shock that the equation of state does not have.
sdpd::SimulationSettings calibrated_settings(Scene const& scene, int threads);

/// Finds them on the scene's own fluid. Throws as calibrate_density.
sdpd::DensityCalibration calibrate(Scene const& scene, int threads, std::function<bool()> const& keep_going);

/// What a calibration is made of: scenes of which this is the same have the same constants.
std::string calibration_identity(Scene const& scene);

/// The constants with their standard errors and the last stage's density and pressure in the scene's units.
Json calibration_json(sdpd::DensityCalibration const& calibration, OutputUnits const& units);

} // namespace mesobridge::workflows
