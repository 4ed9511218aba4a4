#pragma once
#include "sdpd/setup/equilibration.hpp"
#include "sdpd/state/checkpoint.hpp"
#include "workflows/provenance.hpp"
#include <filesystem>

namespace mesobridge::workflows {

/// The checkpoint before the last one, kept in case that the last one is damaged: `checkpoint.h5` has
/// `checkpoint.previous.h5` beside it.
std::filesystem::path previous_checkpoint(std::filesystem::path const& file);

/// Writes a checkpoint with the scene that it belongs to: into a new file, sealed (see store/seal.hpp) and on
/// the disk, which then takes the place of the last one, and that the place of the previous one; so a whole
/// checkpoint is there at any time. Throws EnvironmentError.
void write_checkpoint(std::filesystem::path const& file, sdpd::Checkpoint const& checkpoint,
                      Provenance const& provenance, sdpd::EquilibrationProgress const& equilibration = {});

bool checkpoint_exists(std::filesystem::path const& file); ///< or the previous one does

/// Removes the checkpoint and the previous one, if they are there. Throws EnvironmentError.
void remove_checkpoints(std::filesystem::path const& file);

struct StoredCheckpoint {
  sdpd::Checkpoint checkpoint;
  std::string scene; ///< resolved, as when it was written
  std::vector<InputFile> inputs = {};
  sdpd::EquilibrationProgress equilibration = {}; ///< of a run that still came to equilibrium
  /// Why this is the previous checkpoint, in a sentence for the user; empty when it is the last one.
  std::string warning;
};

/// The last checkpoint or, when it is damaged or missing, the previous one: a run that goes on from there
/// repeats some more steps. Throws InputError, about the last one, if there is neither.
StoredCheckpoint read_checkpoint(std::filesystem::path const& file);

} // namespace mesobridge::workflows
