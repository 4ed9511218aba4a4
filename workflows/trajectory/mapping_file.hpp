#pragma once
#include "cg/molecule_model.hpp"
#include "md/molecule_forces.hpp"
#include "workflows/trajectory/unit_style.hpp"
#include <filesystem>
#include <memory>

namespace mesobridge::workflows {

/// What one molecule of a user's trajectory is made of:
///
///     format = "mesobridge mapping 1"
///     name = "dumbbell"
///     units = "lj"                    # LAMMPS's unit style, of this file and of the trajectory; may be left
///                                     # out: lj. Others: real, metal, si, cgs, micro, nano
///     atoms = 2                       # of a molecule
///     masses = [ 1.0, 1.0 ]
///     types = [ 1, 1 ]                # from 1; may be left out: all 1
///
///     [bonds]                         # may be left out
///     count = 1
///     a = [ 1 ]                       # atoms of the molecule, from 1
///     b = [ 2 ]
///     k = [ 20.0 ]                    # the energy is k (r - l)^2 / 2. Or, instead,
///                                     # K = [ 10.0 ], LAMMPS's: K (r - l)^2
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
///
/// Or, where the force field is more than this (angles, dihedrals, charges, other pairs; molecules among
/// those of other kinds), instead of atoms, masses, types, bonds and pairs:
///
///     [lammps]
///     data = "water.data"             # LAMMPS's data file of all atoms, from this file's folder
///     settings = "water.settings"     # its commands for the force field
///     kind = 1                        # of molecules, if there are several: 1 for that of the first one
struct Mapping {
  std::string name;
  cg::MoleculeModel model; ///< its masses are consistent ones (see UnitStyle)
  UnitStyle units{};
  bool units_given = false;                           ///< false: the default
  std::shared_ptr<md::MoleculeSystem const> system{}; ///< whose energies LAMMPS tells; or none
  std::vector<double> masses{};                       ///< of the atoms, in the unit system's own unit of mass
};

/// Throws InputError with file, line, key and what is allowed.
Mapping read_mapping(std::filesystem::path const& file);

} // namespace mesobridge::workflows
