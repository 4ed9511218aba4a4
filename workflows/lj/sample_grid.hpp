#pragma once
#include "md/lj_grid.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// A grid of Lennard-Jones runs to be made.
struct LjGridJob {
  std::vector<md::LjState> states;
  md::LjFluidSettings settings;
  std::filesystem::path directory; ///< exists; gets lj-grid.h5 and LAMMPS's logs
};

/// Samples the grid into DIRECTORY/lj-grid.h5 as the samples arrive, on the ranks that run already, with
/// progress. Returns on every rank. Throws Interrupted on rank 0 when the user stopped it (what was sampled
/// is in the file), and as md::sample_lj_grid.
void sample_grid(LjGridJob const& job, Context const& context);

} // namespace mesobridge::workflows
