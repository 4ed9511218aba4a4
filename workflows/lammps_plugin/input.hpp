#pragma once
#include "workflows/scene/scene.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"

namespace mesobridge::workflows {

/// Writes into a folder what a LAMMPS with our plugin goes on from a run's checkpoint with: the fluid's scene
/// and the files that it names, the particles as a data file, an input, a batch script, and a page on how the
/// plugin is built. `scene` is that of the checkpoint. Throws InputError where the styles cannot run it.
void write_lammps_input(std::filesystem::path const& folder, Scene const& scene,
                        StoredCheckpoint const& stored, std::int64_t steps);

} // namespace mesobridge::workflows
