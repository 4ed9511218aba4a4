#pragma once
#include "workflows/scene/scene.hpp"
#include <functional>

namespace mesobridge::workflows {

/// A standing wave of sound in a fluid without noise, whose length is `n` particles.
struct SoundWave {
  std::int64_t n;
  double c, c_exact;             ///< velocity [m/s]: measured, and of the equation of state
  double damping, damping_exact; ///< rate [1/s]: measured, and k^2 (4 eta/3 + zeta)/(2 rho)

  double c_error() const { return c / c_exact - 1; }
  double damping_error() const { return damping / damping_exact - 1; }
};

/// A periodic box of the built-in material at rest on a cubic lattice, as long as the wave, with a viscosity
/// that damps it by a fiftieth of its frequency. With 268 neighbours a sum over the lattice is an integral to
/// 0.1 %; with 150 of them sound would be 1.4 % too fast.
Scene sound_scene(std::string const& eos, double rho, double T, std::int64_t n);

/// Starts the wave with velocities of a thousandth of c, and follows it over two periods; `keep_going` is
/// told the part that is done. Throws Interrupted when that says no.
SoundWave measure_sound(Scene const& scene, std::int64_t n, int threads,
                        std::function<bool(double)> const& keep_going);

} // namespace mesobridge::workflows
