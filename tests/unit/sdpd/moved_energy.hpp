#pragma once
#include "sdpd/conservative/refresh.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd/system/total_energy.hpp"

namespace mesobridge::sdpd {

/// Energy of the system with particle i moved, at constant entropies; forces are its slope.
inline double energy_with(System& system, std::size_t i, Vec3 const& by) {
  auto const before = system.particles.q[i];
  system.particles.q[i] += by;
  refresh_by(system, [](System& s) {
    Failure failure;
    if (s.has_densities())
      s.thermodynamics->from_entropy(s.particles, {0, s.size()}, failure);
  });
  system.particles.q[i] = before;
  return total_energy(system);
}

} // namespace mesobridge::sdpd
