#pragma once
#include "sdpd/simulation.hpp"
#include "sdpd/system.hpp"

/// What a simulation is built of, and what brings a system up to date after its particles were changed by
/// hand.
namespace mesobridge::sdpd {

/// Throws InputError when an edge of the box is shorter than twice the range, or when there are more cells of
/// that range in it than can be counted.
void require_cells(Box const& box, double range);

/// Throws InputError when a unit of the engine, or a length in it, is not a positive number: of quantities
/// that are each allowed, and yet too far apart.
void check_units(SimulationSettings const& settings);

Box box_of(SimulationSettings const& settings);

/// Of the neighbour lists, reduced.
double skin_of(SimulationSettings const& settings);

/// Without noise the centres of mass have no thermal motion that could carry anything: bulk.
CentreOfMass centre_of_mass_of(SimulationSettings const& settings);

/// What a particle adds to its own density; the kernel has the scale of the correction.
double self_density(AnyKernel const& kernel, DensityCorrection const& correction);

/// Energies that belong to the particles' temperatures and densities; lists and densities are renewed.
void set_energies_from_temperatures(System& system);

/// Densities, thermodynamics and forces that belong to positions, with `thermodynamics` for what has
/// energies.
void refresh_by(System& system, void (*thermodynamics)(System&));

/// Lists, densities, thermodynamics and forces from positions and energies; the kept energy is that of now.
void refresh(System& system);

} // namespace mesobridge::sdpd
