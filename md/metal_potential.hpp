#pragma once
#include "md/frame.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace mesobridge::md {

enum class Lattice { fcc, bcc, hcp };

/// "fcc", "bcc", "hcp".
std::string_view name_of(Lattice lattice);
/// The lattice of such a name, in any case of letters. Throws InputError.
Lattice lattice_of(std::string const& name);

/// One element of an embedded-atom potential file: E = sum_i F(n_i) + sum_{i<j} phi(r_ij), n_i = sum_j
/// f(r_ij) (md/README.md, Eq. (M5)).
struct MetalPotential {
  std::filesystem::path file;
  std::string style; ///< LAMMPS's pair style: "eam", "eam/alloy" or "eam/fs"
  std::string element;
  double mass = 0; ///< of one atom [kg]
  Lattice lattice = Lattice::fcc;
  double lattice_constant = 0; ///< that the file states [m]
  double cutoff = 0;           ///< [m]
  double largest_density =
      0;              ///< the end of the table of F(n), beyond which LAMMPS goes on in a straight line
  double spacing = 0; ///< of the table of f [m]
  std::vector<double> density; ///< f at r = 0, spacing, ...

  /// Electron density that an atom at distance r [m] gives, by linear interpolation.
  double density_at(double r) const;
};

/// Finds the file (as given, in $LAMMPS_POTENTIALS, or among Debian's lammps-data), and reads what is needed
/// of it. The format follows from the name: .eam (one element, DYNAMO funcfl), .eam.alloy or .alloy (setfl),
/// .eam.fs or .fs (Finnis-Sinclair setfl). An empty element stands for the only one of the file. Throws
/// InputError that names the file and what is wrong.
MetalPotential read_metal_potential(std::string const& file, std::string const& element);

/// Where Debian's package lammps-data puts its potential files.
std::filesystem::path packaged_potentials();

/// The part of the atoms whose electron density lies beyond the table of the embedding function. The frame is
/// in LAMMPS's metal units, and its box at least two cut-offs wide.
double part_beyond_table(MetalPotential const& potential, Frame const& frame);

} // namespace mesobridge::md
