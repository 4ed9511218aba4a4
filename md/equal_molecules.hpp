#pragma once
#include "md/data_file.hpp"
#include <span>

namespace mesobridge::md {

/// What all molecules of a kind have in common. Atoms are counted from 0 in the order of their ids; bonded
/// terms name them so, each once and in one order, sorted.
struct MoleculeKind {
  std::string name;
  std::string atom_style;
  std::vector<int> types; ///< from 1
  std::vector<double> charges;
  std::vector<double> masses_of_types; ///< in LAMMPS's units
  std::array<int, 4> bonded_types{};
  std::array<std::vector<BondedTerm>, 4> bonded; ///< by Bonded

  int atoms() const { return int(types.size()); }
  std::vector<double> masses() const; ///< of its atoms
};

/// Equal molecules in a box.
struct Molecules {
  MoleculeKind kind;
  int count = 0;
  Box box;
  std::vector<Vec3> q; ///< number molecule * atoms + atom; each molecule whole, from a corner at the origin
};

/// The molecules of a data file, in the order of their numbers. Throws InputError that names molecule and
/// atom for atoms of no molecule, bonded terms between molecules and molecules that are not equal in types,
/// charges and bonded terms, and for masses that are missing.
Molecules equal_molecules(DataFile const& data);

/// The box and what is in it, once more beside itself along each edge.
Molecules replicated(Molecules const& molecules, std::array<int, 3> const& times);

/// The largest extent along an axis, on average over the molecules.
double mean_width(Molecules const& molecules);

/// Writes a data file of that many molecules without coefficients, whose atoms have the ids molecule * atoms
/// + 1 + atom.
void write_data_file(std::filesystem::path const& file, MoleculeKind const& kind, std::span<Vec3 const> q,
                     Box const& box);

} // namespace mesobridge::md
