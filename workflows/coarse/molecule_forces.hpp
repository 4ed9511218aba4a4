#pragma once
#include "cg/force_matching.hpp"
#include "workflows/coarse/potential_search.hpp"
#include "workflows/star/blob_file.hpp"

namespace mesobridge::workflows {

/// The forces of a file as force matching takes them, and the structure of the same molecules.
struct ForcesOfFile {
  BlobFileHead head;
  CoarseStructure structure;
  cg::MoleculeForces forces;
};

/// Of blobs, each frame an instant; or of held molecules, each whole configuration one, with its mean forces
/// and the temperature of the motion about the centres. Throws InputError for files without forces, between
/// walls, and as structure_of.
ForcesOfFile read_forces(std::filesystem::path const& file, double bin_width);

} // namespace mesobridge::workflows
