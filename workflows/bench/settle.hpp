#pragma once
#include "sdpd/setup/equilibration.hpp"
#include "sdpd/simulation.hpp"

namespace mesobridge::workflows {

/// From the lattice to where lists last as long as they do later on.
inline void settle(sdpd::Simulation& simulation) {
  constexpr std::uint64_t steps = 64;
  sdpd::equilibrate(simulation, steps, [] { return true; });
}

} // namespace mesobridge::workflows
