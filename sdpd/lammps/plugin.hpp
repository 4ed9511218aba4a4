#pragma once

namespace mesobridge::sdpd {

/// Offers the styles of a fluid to a LAMMPS with the package PLUGIN, as that package asks a library's
/// function `lammpsplugin_init(lammps, handle, register)` to do; set_fluid_reader() comes first.
void offer_fluid_styles(void* lammps, void* handle, void* offer);

} // namespace mesobridge::sdpd
