#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/system/system.hpp"
#include <memory>

namespace mesobridge::sdpd {

/// The start of a simulation, for those that make sub-steps of their own: a lattice, Maxwell velocities
/// without total momentum, every particle at T; densities, energies and forces belong to them. Throws
/// InputError.
std::unique_ptr<System> make_system(SimulationSettings const& settings);

} // namespace mesobridge::sdpd
