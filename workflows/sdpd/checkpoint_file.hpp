#pragma once
#include "sdpd/equilibration.hpp"
#include "workflows/provenance.hpp"
#include <filesystem>

namespace mesobridge::workflows {

/// Writes a checkpoint with the scene that it belongs to: into a new file, flushed, then renamed over the old
/// one, so that a whole checkpoint is there at any time. Throws EnvironmentError.
void write_checkpoint(std::filesystem::path const& file, sdpd::Checkpoint const& checkpoint,
                      Provenance const& provenance, sdpd::EquilibrationProgress const& equilibration = {});

struct StoredCheckpoint {
  sdpd::Checkpoint checkpoint;
  std::string scene; ///< resolved, as when it was written
  std::vector<InputFile> inputs = {};
  sdpd::EquilibrationProgress equilibration = {}; ///< of a run that still came to equilibrium
};

/// Throws InputError if the file is missing or incomplete.
StoredCheckpoint read_checkpoint(std::filesystem::path const& file);

} // namespace mesobridge::workflows
