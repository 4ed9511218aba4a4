#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Kernels whose force vanishes as two particles meet let them stick together: the pairing instability of
/// smoothed particles (Dehnen and Aly, Mon. Not. R. Astron. Soc. 425 (2012) 1068). Pairs count once in the
/// noise of a density and twice in its cost, and drag pressure and density with them as they grow.
inline constexpr double pairing_distance = 0.35; ///< in mean distances between particles, (V/N)^(1/3)

/// The share of the particles that have a neighbour nearer than pairing_distance, 0 ... 1; 0.16 where they
/// lie at random. Reads the pairs in range of the last evaluation of the densities.
double pairing_fraction(System const& system);

/// The largest share that says nothing against a fluid of particles of K molecules: 1 %, and what thermal
/// motion brings together, which falls with their size (4 % of an ideal gas at K = 10, 2.5 % of argon at K =
/// 5) and harms neither pressure nor density.
double tolerable_pairing(double K);

} // namespace mesobridge::sdpd
