#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// What the mean of the particles' densities does when the box is compressed affinely, with all positions and
/// at a fixed support: d<rho>/d ln(1/V) = (1/3N) sum_i sum_j m_j F_ij r_ij^2, in units of the mean density. A
/// density that follows the mass per volume has 1 (sdpd/README.md, Eq. (S33)). The virial is this sum with
/// the weights P/rho^2. Reads the pairs in range of the last evaluation of the densities.
double compression_response(System const& system);

} // namespace mesobridge::sdpd
