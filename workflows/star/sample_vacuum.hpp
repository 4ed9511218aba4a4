#pragma once
#include "md/star_vacuum.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Isolated molecules to be sampled; settings.directory gets the files, named after the ensemble.
struct VacuumJob {
  md::StarVacuumSettings settings;
  bool resume = false; ///< go on from the checkpoint, if there is one

  std::filesystem::path blobs() const;
  std::filesystem::path summary() const;
};

/// Makes the run on the ranks that this process is one of, with progress; every rank returns. Throws
/// Interrupted on rank 0 when the user stopped it, and as md::sample_star_vacuum.
void sample_vacuum(VacuumJob const& job, Context const& context);

/// The same on as many ranks as the context asks for, by starting this program anew if need be.
void sample_vacuum_on_ranks(VacuumJob const& job, Context const& context);

/// The words that have this program make the run and print no result.
std::vector<std::string> words_of(VacuumJob const& job);

} // namespace mesobridge::workflows
