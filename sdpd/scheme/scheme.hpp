#pragma once
#include "sdpd/state/particles.hpp"
#include "sdpd/system/sub_step.hpp"
#include <span>

namespace mesobridge::sdpd {

enum class Splitting {
  lie_trotter, ///< conservative step, then fluctuation and dissipation, as in the thesis
  strang       ///< half of fluctuation and dissipation, conservative step, the other half
};

/// A scheme: how the conservative dynamics and the pairs' fluctuation and dissipation alternate
/// (sdpd/README.md, A step).
struct Scheme {
  std::string pairs = "ssa"; ///< how pairs fluctuate and dissipate, by its name in the list
  /// Conservative steps for one sweep of fluctuation and dissipation (multiple time steps, theta), >= 1.
  std::uint32_t verlet_steps = 1;
  Splitting splitting = Splitting::lie_trotter;
  std::string conservative =
      "verlet"; ///< how positions and momenta follow the forces, by its name in the list
  /// Takes the energy that the Verlet steps lose or gain out of the internal energies after each sweep, by
  /// one factor for all particles' temperatures.
  bool keep_energy = false;
};

/// Throws InputError when the scheme names what is not in the lists, or what cannot be used for such
/// particles with or without noise.
void check(Scheme const& scheme, Features const& particles, bool noise);

/// The scheme as a list of what a step over dt does to such a system, in this order: one conservative step at
/// constant entropies, and fluctuation and dissipation when it is their turn. The scheme has been checked.
std::vector<SubStep> sub_steps(Scheme const& scheme, System const& system, double dt);

/// Makes those of the sub-steps whose turn it is; in builds without NDEBUG each is checked for what it
/// conserves (run_and_check). Before and after it, eps, S, T, P and f belong to the positions. Throws
/// PhysicsError when a particle leaves the equation of state.
void step(System& system, std::span<SubStep const> sub_steps);

/// One step of a scheme, made a list of for this alone.
void step(System& system, Scheme const& scheme, double dt);

} // namespace mesobridge::sdpd
