#pragma once
#include "md/equal_molecules.hpp"
#include "md/force_field.hpp"
#include "md/molecule_atoms.hpp"
#include <optional>

namespace mesobridge::md {

/// A user's molecules and the forces between their atoms.
struct MoleculeSystem {
  Molecules molecules;
  ForceField forces;
  std::string units;                   ///< LAMMPS's unit style
  std::vector<InputLine> coefficients; ///< that the data file holds

  /// LAMMPS's units and styles, before there are atoms.
  void prepare(LammpsSession& lammps) const;
  /// All forces, and what collect_molecules reads, for a session whose atoms are there.
  void set_forces(LammpsSession& lammps) const;
};

/// What the command line says besides the two files; empty: what these say, or else LAMMPS's usual style.
struct MoleculeStyles {
  std::string units, atom_style;
};

/// Reads both files. Throws InputError that names file and line for what cannot be read, molecules that
/// are not equal, and styles that contradict each other.
MoleculeSystem read_molecule_system(std::filesystem::path const& data, std::filesystem::path const& settings,
                                    MoleculeStyles const& styles);

/// The potential energy inside each molecule, whatever the pair style: what LAMMPS makes of the same atoms
/// when pairs of different molecules do not count (md/README.md, Eq. (M12)).
class InsideEnergies {
 public:
  /// `folder` gets files for a moment.
  InsideEnergies(MpiWorld const& world, MoleculeSystem const& system, std::filesystem::path folder);

  /// Adds `inside` and `reach` to this rank's molecules, all of one box. Throws InputError when LAMMPS
  /// refuses the force field.
  void add_to(MoleculeFrame& frame);

 private:
  void start(MoleculeFrame const& frame);

  MpiWorld const& world_;
  MoleculeSystem const& system_;
  std::filesystem::path folder_;
  std::optional<LammpsSession> lammps_;
  double reach_ = 0;
};

} // namespace mesobridge::md
