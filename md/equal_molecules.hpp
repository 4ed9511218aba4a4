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
  std::vector<std::int64_t> ids{}; ///< of the atoms in the data file, as those of q; empty: none
  std::vector<Vec3> q; ///< number molecule * atoms + atom; each molecule whole, from a corner at the origin
};

/// The molecules of a data file by their kinds, equal in types, charges and bonded terms; kinds in the order
/// of their first molecules, molecules in that of their numbers. Throws InputError that names molecule and
/// atom for atoms of no molecule, bonded terms between molecules, and for masses that are missing.
std::vector<Molecules> molecules_by_kind(DataFile const& data);

/// The molecules of a data file that has one kind. Throws InputError that also names what differs.
Molecules equal_molecules(DataFile const& data);

/// The rectangular box and what is in it, once more beside itself along each edge.
Molecules replicated(Molecules const& molecules, std::array<int, 3> const& times);

/// The largest extent along an axis, on average over the molecules.
double mean_width(Molecules const& molecules);

/// Writes a data file of that many molecules without coefficients, whose atoms have the ids molecule * atoms
/// + 1 + atom.
void write_data_file(std::filesystem::path const& file, MoleculeKind const& kind, std::span<Vec3 const> q,
                     Box const& box);

/// So many molecules of a kind.
struct CountedKind {
  MoleculeKind const* kind = nullptr;
  std::size_t count = 0;
};

/// The same of several kinds of one data file, one after the other; ids are places in `q`, from 1.
void write_data_file(std::filesystem::path const& file, std::vector<CountedKind> const& parts,
                     std::span<Vec3 const> q, Box const& box);

} // namespace mesobridge::md
