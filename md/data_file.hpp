#pragma once
#include "md/box.hpp"
#include "md/input_lines.hpp"
#include <array>

namespace mesobridge::md {

/// What bonded terms a data file has, in the order in which LAMMPS names them.
enum class Bonded { bond, angle, dihedral, improper };
inline constexpr std::array bonded_kinds{Bonded::bond, Bonded::angle, Bonded::dihedral, Bonded::improper};
inline constexpr std::array bonded_names{"bond", "angle", "dihedral", "improper"};
inline constexpr std::array<std::size_t, 4> bonded_atoms{2, 3, 4, 4};

/// A bonded term of one type between two to four atoms.
struct BondedTerm {
  int type = 0;                        ///< from 1
  std::array<std::int64_t, 4> atoms{}; ///< those that are not there are 0
  auto operator<=>(BondedTerm const&) const = default;
};

struct DataAtom {
  std::int64_t id = 0, molecule = 0;
  int type = 0; ///< from 1
  double charge = 0;
  Vec3 q;
};

/// A data file as LAMMPS's read_data takes it, of atoms with molecules.
struct DataFile {
  std::filesystem::path file;
  std::string atom_style; ///< bond, angle, molecular or full
  Vec3 low;
  Box box;
  int atom_types = 0;
  std::array<int, 4> bonded_types{};
  std::vector<double> masses;                    ///< of each atom type; 0 where the file does not say it
  std::vector<DataAtom> atoms;                   ///< in the order of the file
  std::array<std::vector<BondedTerm>, 4> bonded; ///< by Bonded
  std::vector<InputLine> coefficients;           ///< as commands: "bond_coeff 1 harmonic ..."

  bool charged() const { return atom_style == "full"; }
};

/// Reads a data file; an atom style that is not empty is the user's word, and must not differ from what the
/// file says. Velocities are passed over. Throws InputError with file and line.
DataFile read_data_file(std::filesystem::path const& file, std::string const& atom_style);

} // namespace mesobridge::md
