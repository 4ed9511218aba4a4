#pragma once
#include "workflows/sdpd/engine.hpp"
#include "workflows/sdpd/settings.hpp"

namespace mesobridge::workflows {

/// The settings of the scene; an automatic time step stands as the largest that it may become, which makes
/// the widest skin.
sdpd::SimulationSettings settings_for_check(Scene const& scene, int threads);

/// All for which a run of the scene is refused before its first step: models and tables, the number of
/// samples, the box against the reach of the interaction, and what the study of a time step and a calibration
/// want. It takes the same short time for any number of particles. Throws InputError that names the key;
/// PhysicsError when the model has no such state.
void check_run(Scene const& scene, int threads);

/// Reads a scene that is to be run: load_scene and check_run, whose messages then name the file. What the
/// engine cannot run is refused likewise.
Scene load_run(std::filesystem::path const& file, std::vector<std::string> const& overrides, int threads,
               Engine engine = Engine::built_in);

} // namespace mesobridge::workflows
