#pragma once
#include "md/molecule_forces.hpp"

namespace mesobridge::workflows {

/// A force field that a mapping cannot hold itself: other styles than harmonic and FENE bonds and lj/cut,
/// angles, dihedrals, charges, weights of pairs that are not bonded directly, molecules of other kinds. Its
/// text names file, line and word.
struct NotHeldByMapping : InputError {
  using InputError::InputError;
};

/// The mapping (see mapping_file.hpp) of a user's molecules, with LAMMPS's K named as K. Throws
/// NotHeldByMapping, and InputError that names file, line and word for what is wrong.
std::string mapping_text(md::MoleculeSystem const& system);

} // namespace mesobridge::workflows
