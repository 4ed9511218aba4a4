#pragma once
#include "md/input_lines.hpp"
#include "md/lammps_session.hpp"

namespace mesobridge::md {

/// The forces between atoms as the user tells them to LAMMPS: a file of its commands, and the coefficients
/// that a data file holds. It holds nothing that moves atoms, chooses a run or needs a mesh.
class ForceField {
 public:
  /// Reads the settings. Throws InputError that names file, line and word for commands that are not of a
  /// force field, and for those whose energies cannot be told molecule by molecule.
  explicit ForceField(std::filesystem::path const& file);

  std::filesystem::path const& file() const { return file_; }
  /// LAMMPS's unit style, atom style; empty where the settings do not say it.
  std::string const& units() const { return units_; }
  std::string const& atom_style() const { return atom_style_; }
  /// All lines but `units` and `atom_style`, in the order of the file.
  std::vector<InputLine> const& lines() const { return lines_; }
  /// The lines that begin with a word.
  std::vector<InputLine> all_of(std::string const& command) const;

  /// Styles and weights of bonded pairs, which LAMMPS must know before it reads atoms.
  void set_styles(LammpsSession& lammps) const;
  /// Everything, for a session whose atoms are there: styles, the coefficients of the data file (as
  /// commands), the other lines. Throw InputError with LAMMPS's own message and the line.
  void set_all(LammpsSession& lammps, std::vector<InputLine> const& coefficients_of_data) const;

 private:
  void take(InputLine line);
  void run(LammpsSession& lammps, InputLine const& line) const;

  std::filesystem::path file_;
  std::string units_, atom_style_;
  std::vector<InputLine> lines_;
};

} // namespace mesobridge::md
