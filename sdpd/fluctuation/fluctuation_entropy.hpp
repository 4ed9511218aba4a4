#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// What the noise of the original SDPD gives to the first particle of a pair (thesis, Eq. (2.2)):
///     (A dW_s + (B/3) Tr(dW) I) e,
/// dW_s the symmetric part of a 3x3 matrix of Gaussian numbers of variance dt without its trace. `diagonal`
/// holds its diagonal elements, `off` the elements yz, xz, xy of its symmetric part times sqrt(2): six
/// standard Gaussian numbers. Both directions are driven by the same matrix (the thesis prints W_ij = -W_ji,
/// which would not conserve the momentum). With A^2 = 8 k_B a tau, B^2 = 12 k_B b tau, tau = T_i T_j/(T_i +
/// T_j), its covariance is 4 k_B tau [a P_perp + (4a/3 + b) P_par] dt, that of the energy form.
Vec3 matrix_noise(double A, double B, Vec3 const& e, Vec3 const& diagonal, Vec3 const& off);

/// Fluctuation and dissipation over dt in the original form of SDPD (thesis, Eq. (2.6)), whose variables are
/// the entropies: all pairs at once from the start (Euler and Maruyama),
///     dp_i   = -(1-d)[a v + (a/3 + b)(e v) e] dt + noise = -dp_j,
///     T_i dS_i = (D_i/2)[a v^2 + (a/3 + b)(e v)^2] dt - 2 k_B tau (10a/3 + b)/m_ij dt - (1/2) v noise,
///     D_i = 1 - d - (k_B/C_i) T_j/(T_i + T_j).
/// D_i and the factor 2 follow from the energy form, Eq. (S11), by Ito's rule; the thesis prints
/// 1 - d + (k_B/C_i) T_i/(T_i + T_j) and 8, with which the energy would drift at any dt. Momentum is
/// conserved to round-off, energy only in the limit of short steps: explicit Euler steps heat the fluid at a
/// rate proportional to dt (ideal gas, K = 10: E/E_0 rises by 37 dt per unit of time; K = 100: by 0.8 dt).
/// For comparison with the energy form. Throws InputError for other laws than SDPD's, PhysicsError when there
/// is no state of the new entropy.
void fluctuate_entropies(System& system, double dt, bool second = false);

} // namespace mesobridge::sdpd
