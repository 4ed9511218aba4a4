#pragma once
#include "md/molecule_forces.hpp"

namespace mesobridge::workflows {

/// The mapping that names LAMMPS's files, as they are found from `folder`.
std::string mapping_of_files_text(md::MoleculeSystem const& system, std::optional<int> kind,
                                  std::filesystem::path const& folder);

} // namespace mesobridge::workflows
