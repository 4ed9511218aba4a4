#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include <cstdint>

namespace mesobridge::sdpd {

struct System;

enum class Splitting {
  lie_trotter, ///< conservative step, then fluctuation and dissipation, as in the thesis
  strang       ///< half of fluctuation and dissipation, conservative step, the other half
};

/// How positions and momenta follow the conservative forces over a time step.
enum class Conservative {
  verlet,    ///< Velocity Verlet: one evaluation of the forces
  two_stage, ///< half a step of drift twice between three kicks: two evaluations, a far smaller energy error
  none       ///< positions stay where they are: fluctuation and dissipation alone, for studies of it
};

/// A scheme: how the conservative dynamics and the pairs' fluctuation and dissipation alternate
/// (sdpd/README.md, A step).
struct Scheme {
  PairScheme pairs = PairScheme::ssa;
  /// Conservative steps for one sweep of fluctuation and dissipation (multiple time steps, theta), >= 1.
  std::uint32_t verlet_steps = 1;
  Splitting splitting = Splitting::lie_trotter;
  Conservative conservative = Conservative::verlet;
  /// Takes the energy that the Verlet steps lose or gain out of the internal energies after each sweep, by
  /// one factor for all particles' temperatures.
  bool keep_energy = false;
};

/// One conservative step over dt at constant entropies, and fluctuation and dissipation when it is their
/// turn. Before and after it, eps, S, T, P and f belong to the positions. Throws PhysicsError when a particle
/// leaves the equation of state.
void step(System& system, Scheme const& scheme, double dt);

} // namespace mesobridge::sdpd
