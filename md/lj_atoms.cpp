#include "md/lj_atoms.hpp"

namespace mesobridge::md {

void create_lj_atoms(LammpsSession& lammps, LjLattice const& lattice, double cutoff, bool tail) {
  lammps.command("units lj");
  lammps.command("atom_style atomic");
  lammps.command("lattice fcc {}", lattice.rho);
  lammps.command("region box block 0 {0} 0 {0} 0 {1}", lattice.cells_across, lattice.cells_along);
  lammps.command("create_box 1 box");
  lammps.command("create_atoms 1 box");
  lammps.command("mass 1 1.0");
  lammps.command("pair_style {} {}", lammps.has_style("pair", "lj/cut/opt") ? "lj/cut/opt" : "lj/cut",
                 cutoff);
  lammps.command("pair_modify shift no tail {}", tail ? "yes" : "no");
  lammps.command("pair_coeff 1 1 1.0 1.0");
  lammps.command("neighbor 0.4 bin");
  lammps.command("neigh_modify every 2 delay 0 check yes");
  lammps.command("compute_modify thermo_temp extra/dof 0");
}

} // namespace mesobridge::md
