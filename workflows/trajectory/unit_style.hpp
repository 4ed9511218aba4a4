#pragma once
#include <optional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// One of LAMMPS's unit styles, as trajectories and mappings use them. Masses become consistent ones, (energy
/// unit) (time unit)^2 / (length unit)^2, so that m v^2 / 2 is an energy beside the potential ones.
struct UnitStyle {
  std::string name;          ///< as LAMMPS's command `units` says it
  double energy_of_mv2 = 1;  ///< (mass unit) (length unit / time unit)^2 in the energy unit
  double length = 0;         ///< [m]; 0: reduced units, without a value
  double time = 0;           ///< [s]; likewise
  std::string description{}; ///< "kcal/mol, Angstrom, fs", for people

  bool reduced() const { return length == 0; }
};

/// lj, real, metal, si, cgs, micro, nano. Throws InputError for others; LAMMPS's `electron`, whose own time
/// and velocity units differ, is refused by name.
UnitStyle unit_style(std::string const& name);

/// The value in SI of a product of units of length and time as the units module of H5MD writes it, "nm ps-1";
/// throws InputError when a factor is unknown or the dimension is not length^`lengths` time^`times`.
double value_in_si(std::string const& unit, int lengths, int times);

} // namespace mesobridge::workflows
