#pragma once

namespace mesobridge::md {

/// How far beyond its part of the box a rank of LAMMPS will look for images of atoms: cut-offs of the force
/// field and skin. Prepares LAMMPS for a run, as its `run` does once more. `lammps` is the LAMMPS object.
double ghost_cutoff(void* lammps);

} // namespace mesobridge::md
