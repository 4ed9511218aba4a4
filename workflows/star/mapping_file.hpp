#pragma once
#include "cg/molecule_model.hpp"
#include <filesystem>
#include <string>

namespace mesobridge::workflows {

/// What one molecule of a user's trajectory is made of, in the units of the trajectory:
///
///     format = "mesobridge mapping 1"
///     name = "dumbbell"
///     atoms = 2                       # of a molecule
///     masses = [ 1.0, 1.0 ]
///     types = [ 1, 1 ]                # from 1; may be left out: all 1
///
///     [bonds]                         # k (r - l)^2 / 2; may be left out
///     count = 1
///     a = [ 1 ]                       # atoms of the molecule, from 1
///     b = [ 2 ]
///     k = [ 20.0 ]
///     l = [ 1.147 ]
///
///     [pairs]                         # Lennard-Jones, cut; may be left out
///     count = 1
///     type_a = [ 1 ]
///     type_b = [ 1 ]
///     epsilon = [ 1.0 ]
///     sigma = [ 1.0 ]
///     cutoff = [ 1.122462048309373 ]
///     shifted = "yes"                 # zero at the cut-off
///     bonded = "yes"                  # "no": bonded atoms do not interact as pairs
struct Mapping {
  std::string name;
  cg::MoleculeModel model;
};

/// Throws InputError with file, line, key and what is allowed.
Mapping read_mapping(std::filesystem::path const& file);

} // namespace mesobridge::workflows
