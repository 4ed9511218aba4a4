#pragma once
#include "md/molecule_forces.hpp"

namespace mesobridge::workflows {

/// The mapping (see mapping_file.hpp) of a user's molecules, with LAMMPS's K named as K. Throws InputError
/// that names file, line and word for what a mapping cannot hold: other styles than harmonic and FENE bonds
/// and lj/cut, angles, dihedrals, weights of pairs that are not bonded directly.
std::string mapping_text(md::MoleculeSystem const& system);

} // namespace mesobridge::workflows
