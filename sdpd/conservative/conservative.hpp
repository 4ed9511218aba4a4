#pragma once
#include "sdpd/system/system.hpp"

/// The sub-steps of the conservative dynamics: Velocity Verlet at constant entropies (sdpd/README.md,
/// Eq. (S28)); the densities are Eq. (S5), the forces Eq. (S9).
namespace mesobridge::sdpd {

/// p += f dt. Conserves the momentum, since the forces do.
void kick(System& system, double dt);

/// p += f kick_dt, then q += p/m drift_dt, in one pass over the particles.
void kick_and_drift(System& system, double kick_dt, double drift_dt);

/// Renews the neighbour lists if some particle has come too far. Throws PhysicsError when a position is not
/// finite.
void refresh_lists(System& system);

/// Picks the pairs in range from the candidates and sums rho_i = sum_j m_j W_ij with the self term.
void find_pairs_and_densities(System& system);

/// T, eps and P of every particle from its entropy and its density.
void thermodynamics_from_entropy(System& system);

/// P and the caloric expansion of every particle from its temperature and its density, energies and entropies
/// untouched.
void response_from_temperature(System& system);

/// T, S and P of every particle from its internal energy and its density.
void thermodynamics_from_energy(System& system);
/// T and S alone of the energies, where no pressure is asked for.
void temperature_from_energy(System& system);

/// Conservative forces f_i = sum_j m_i m_j (P_i/rho_i^2 + P_j/rho_j^2) F_ij r_ij (Eq. (S9)) and their virial.
void find_forces(System& system);

} // namespace mesobridge::sdpd
