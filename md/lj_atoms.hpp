#pragma once
#include "md/lammps_session.hpp"

namespace mesobridge::md {

/// Lennard-Jones atoms on a face-centred cubic lattice in a fresh session.
struct LjLattice {
  double rho; ///< density of the atoms, in Lennard-Jones units
  int cells_across, cells_along;
};

/// Makes the atoms and their forces (md/README.md, Eq. (M2)): cut at `cutoff`, not shifted, with or without
/// the mean part beyond it. Temperatures count all 3N momenta, those of the centre of mass too, on all of
/// which the thermostat acts.
void create_lj_atoms(LammpsSession& lammps, LjLattice const& lattice, double cutoff, bool tail);

} // namespace mesobridge::md
