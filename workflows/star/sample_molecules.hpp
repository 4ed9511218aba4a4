#pragma once
#include "md/molecule_melt.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// A melt of a user's molecules; settings.directory gets blobs.h5, centres.h5 (H5MD of the centres of mass),
/// summary.json, LAMMPS's log and the checkpoint.
struct MoleculesJob {
  md::MoleculeMeltSettings settings;
  bool resume = false; ///< go on from the checkpoint, if there is one

  std::filesystem::path blobs() const { return settings.directory / "blobs.h5"; }
  std::filesystem::path summary() const { return settings.directory / "summary.json"; }
};

/// Makes the run on the ranks that this process is one of, with progress; every rank returns. Throws
/// Interrupted on rank 0 when the user stopped it, InputError when the energies of the molecules do not add
/// up to LAMMPS's, and as md::sample_molecules.
void sample_molecules(MoleculesJob const& job, Context const& context);

} // namespace mesobridge::workflows
