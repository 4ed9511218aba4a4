#pragma once
#include "workflows/scene/scene.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/sdpd/trajectories.hpp"

namespace mesobridge::workflows {

/// A run that is there, as it is resumed.
struct PastRun {
  StoredCheckpoint stored;
  FrameSchedules frames; ///< as the stored scene has them
};
PastRun past_run(StoredCheckpoint stored);

/// The scene that a run goes on with: that of today with what the run found itself, its time step and the
/// constants of its densities, and with the intervals of its instants and of its film where the scene leaves
/// them open, for they follow from the steps. May differ from the stored one in the number of steps, in
/// titles and folders, in what is written besides samples and instants and how often, and in the schedule of
/// checkpoints. Anything else is refused: InputError that names each key with both values, or the input file
/// whose content has changed. `place` names the stored scene in messages.
Scene resumed_scene(Scene scene, std::string const& stored_scene, std::vector<InputFile> const& stored_inputs,
                    std::filesystem::path const& place);

} // namespace mesobridge::workflows
