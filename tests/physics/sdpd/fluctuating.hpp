#pragma once
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Fluctuation and dissipation alone, at fixed places: calls record() at decorrelated instants, `between`
/// steps apart, after 20 others.
void at_instants(System& system, PairScheme scheme, double dt, int instants, int between,
                 auto const& record) {
  for (int k = -20; k < instants; ++k) {
    for (int s = 0; s < between; ++s, ++system.step) {
      fluctuate(system, scheme, dt);
      thermodynamics_from_energy(system);
    }
    if (k >= 0)
      record();
  }
}

} // namespace mesobridge::sdpd
