#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// The virial of each particle in DPD and DPDE, half of f_ij . r_ij of all its pairs, by id and in reduced
/// units; empty for SDPD, whose particles have pressures of their own. Together they are the virial of the
/// fluid. At the positions at which the forces were found last.
std::vector<double> virials(System const& system);

} // namespace mesobridge::sdpd
