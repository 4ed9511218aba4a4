#pragma once
#include "md/box.hpp"
#include "md/lammps_session.hpp"
#include <cstdint>
#include <vector>

namespace mesobridge::md {

/// One instant of many equal molecules: this rank's share of them, whole, whichever ranks own their atoms.
/// The atoms of a molecule stand together, in the order of their ids. In LAMMPS's units.
struct MoleculeFrame {
  std::int64_t step = 0;
  double time = 0;
  Box box;
  double energy = 0;      ///< LAMMPS's total energy of the whole system
  double pressure = 0;    ///< LAMMPS's pressure, as energy/volume
  int first_molecule = 0; ///< number of this rank's first molecule, from 0
  int molecules = 0;      ///< of this rank
  int atoms_per_molecule = 0;
  std::vector<Vec3> q, v, f;     ///< q may lie a little outside the box
  std::vector<double> potential; ///< each atom's half of the pair and bond energies that it takes part in
  /// The potential energy inside each molecule; empty where whoever takes the frame knows its laws.
  std::vector<double> inside;
  double reach = 0; ///< where `inside` is given: how far pairs of atoms see each other
};

/// The compute pe/atom that collect_molecules reads. It is to be defined once in a session, which makes every
/// thermo output tally the energies.
inline constexpr char const* atom_energy_compute = "mesobridge_energy";
void tally_atom_energies(LammpsSession& lammps);

/// Brings the atoms of each molecule together: molecule m goes to rank m * ranks / molecules. Atom ids are
/// molecule * atoms_per_molecule + 1 + number in the molecule. All ranks must call it, right after a run.
/// Throws PhysicsError when an atom is missing.
MoleculeFrame collect_molecules(MpiWorld const& world, LammpsSession& lammps, int molecules,
                                int atoms_per_molecule);

} // namespace mesobridge::md
