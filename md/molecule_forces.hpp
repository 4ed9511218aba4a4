#pragma once
#include "md/equal_molecules.hpp"
#include "md/force_field.hpp"
#include "md/molecule_atoms.hpp"
#include <optional>

namespace mesobridge::md {

/// A user's molecules and the forces between their atoms.
struct MoleculeSystem {
  std::filesystem::path data;
  Molecules molecules;
  std::vector<Molecules> others{}; ///< of other kinds, among which these are
  ForceField forces;
  std::string units;                   ///< LAMMPS's unit style
  std::vector<InputLine> coefficients; ///< that the data file holds

  /// LAMMPS's units and styles, before there are atoms.
  void prepare(LammpsSession& lammps) const;
  /// All forces, and what collect_molecules reads, for a session whose atoms are there.
  void set_forces(LammpsSession& lammps) const;
  /// Throws LammpsError where cut-offs and skin reach so far beyond the box that LAMMPS would have to keep
  /// more than 10^7 images of its atoms; it would fill the memory with them before it said so.
  void require_few_images(LammpsSession& lammps, Box const& box) const;
};

/// What the command line says besides the two files; empty: what these say, or else LAMMPS's usual style.
struct MoleculeStyles {
  std::string units, atom_style;
};

/// Reads both files; `kind`, from 1, is that of the molecules, where there are several. Throws InputError
/// that names file and line for what cannot be read, molecules that are not equal and no kind, and styles
/// that contradict each other.
MoleculeSystem read_molecule_system(std::filesystem::path const& data, std::filesystem::path const& settings,
                                    MoleculeStyles const& styles, std::optional<int> kind = {});

/// What LAMMPS says of the atoms of one instant.
struct AtomEnergies {
  std::vector<double> potential; ///< halves of pairs, equal parts of bonded terms
  std::vector<Vec3> f;
  double reach = 0; ///< how far pairs of atoms see each other
};

/// A LAMMPS of this rank that tells energies and forces of instants of a system.
class FrameEnergies {
 public:
  /// Which atoms, and whether those of different molecules interact.
  enum class Of {
    whole_system,     ///< all atoms of the data file
    inside_molecules, ///< the molecules of the system's kind, each by itself
  };

  /// `folder` gets files for a moment.
  FrameEnergies(MpiWorld const& world, MoleculeSystem const& system, Of what, std::filesystem::path folder);

  /// Of atoms in a periodic box: those of the system's molecules, in their order; of the whole system those
  /// of the other kinds follow. Throws InputError when LAMMPS refuses the force field.
  AtomEnergies of(std::span<Vec3 const> q, Box const& box);

 private:
  void start(std::span<Vec3 const> q, Box const& box);
  void take_box(Box const& box);

  MpiWorld const& world_;
  MoleculeSystem const& system_;
  Of what_;
  std::filesystem::path folder_;
  std::optional<LammpsSession> lammps_;
  Box box_;
  double reach_ = 0;
};

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
  FrameEnergies energies_;
};

} // namespace mesobridge::md
