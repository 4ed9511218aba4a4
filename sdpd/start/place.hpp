#pragma once
#include "sdpd/start/layout.hpp"
#include "sdpd/state/particles.hpp"

namespace mesobridge::sdpd {

/// Gives particles ids, positions and temperatures by a layout, in the order of its places, with Gaussian
/// displacements of the standard deviation `disorder` in spacings of each region. Returns each one's region.
std::vector<std::uint32_t> place(Particles& particles, Layout const& layout, double disorder,
                                 std::uint64_t seed);

/// Gives each particle its region's velocity where it stands.
void let_flow(Particles& particles, Layout const& layout, std::vector<std::uint32_t> const& regions);

/// Particles that have a temperature of their motion together: the group of each, none where there is but
/// one, and the groups' temperatures.
struct ThermalGroups {
  std::vector<std::uint32_t> of = {};
  std::vector<double> T = {1};
};

/// Adds Maxwell velocities. The momenta of a group's N particles sum to zero, and their kinetic energy is
/// (3/2)(N-1) k_B T.
void draw_momenta(Particles& particles, ThermalGroups const& groups, double boltzmann, std::uint64_t seed);

} // namespace mesobridge::sdpd
