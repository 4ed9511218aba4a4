#pragma once
#include "md/star_melt.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// A melt to be made; settings.directory gets blobs.h5, centres.h5 (H5MD of the centres of mass),
/// summary.json, LAMMPS's log and the checkpoint.
struct MeltJob {
  md::StarMeltSettings settings;
  bool resume = false; ///< go on from the checkpoint, if there is one

  std::filesystem::path blobs() const { return settings.directory / "blobs.h5"; }
  std::filesystem::path summary() const { return settings.directory / "summary.json"; }
};

/// Makes the run on the ranks that this process is one of, with progress; every rank returns. Throws
/// Interrupted on rank 0 when the user stopped it, and as md::sample_star_melt.
void sample_melt(MeltJob const& job, Context const& context);

/// The same on as many ranks as the context asks for, by starting this program anew if need be.
void sample_melt_on_ranks(MeltJob const& job, Context const& context);

/// The words that have this program make the run and print no result.
std::vector<std::string> words_of(MeltJob const& job);

} // namespace mesobridge::workflows
