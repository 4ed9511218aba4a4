#pragma once
#include "md/held_blobs.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// A melt whose molecules are to be held; settings.directory gets held.h5, summary.json, LAMMPS's log and the
/// checkpoint.
struct HeldJob {
  md::HeldBlobsSettings settings;
  bool resume = false; ///< go on from the checkpoint, if there is one

  std::filesystem::path blobs() const { return settings.directory / "held.h5"; }
  std::filesystem::path summary() const { return settings.directory / "summary.json"; }
};

/// Makes the run on the ranks that this process is one of, with progress; every rank returns. Throws
/// Interrupted on rank 0 when the user stopped it, and as md::sample_held_blobs.
void sample_held(HeldJob const& job, Context const& context);

/// The same on as many ranks as the context asks for, by starting this program anew if need be.
void sample_held_on_ranks(HeldJob const& job, Context const& context);

/// The words that have this program make the run and print no result.
std::vector<std::string> words_of(HeldJob const& job);

/// What a finished run tells, for people.
std::string held_text(Json const& summary);

} // namespace mesobridge::workflows
