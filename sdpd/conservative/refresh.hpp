#pragma once
#include "sdpd/system/system.hpp"

/// What brings a system up to date after its particles were changed by hand.
namespace mesobridge::sdpd {

/// Energies that belong to the particles' temperatures and densities; lists and densities are renewed.
void set_energies_from_temperatures(System& system);

/// Densities, thermodynamics and forces that belong to positions, with `thermodynamics` for what has
/// energies.
void refresh_by(System& system, void (*thermodynamics)(System&));

/// Lists, densities, thermodynamics and forces from positions and energies; the kept energy is that of now.
void refresh(System& system);

} // namespace mesobridge::sdpd
