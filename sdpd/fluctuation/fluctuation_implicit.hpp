#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Fluctuation and dissipation over dt with all pairs at once, stable at any dt: SER with the friction taken
/// at the mean p_m of the momenta before and after (sdpd/README.md, Eq. (S26)),
///     dp_i = sum_j (-Gamma_ij v_m,ij dt + Sigma_ij G_ij dt^(1/2)),   p_m = p + dp/2,
/// at the temperatures of the start. Its equations (1 + Gamma dt/2) p_m = p + noise/2 are symmetric and
/// positive definite: conjugate gradients solve them, to 1e-4 of the right-hand side. At one temperature the
/// step leaves Maxwell's law of the momenta exactly alone at any dt (with A = 1 + Gamma dt/2, B = 1 - Gamma
/// dt/2 and the noise's variance 2 k_B T Gamma dt, B^2 + 2 Gamma dt = A^2). The heat of a pair is
/// -(1/2) dp_ij (v_ij + (dp_i - dp_j)/2) for each of the two, so that momentum and energy are conserved to
/// round-off, however well the equations were solved.
///
/// The pairs of particles that would leave the equation of state are taken back, and their steps made one
/// after the other afterwards, unless such a step leaves the equation of state too (AMS); PairCounts tells
/// how many these were. Throws InputError for pair laws without internal energies, PhysicsError when the
/// gradients do not converge.
void fluctuate_implicit(System& system, double dt, bool second = false);

} // namespace mesobridge::sdpd
