#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/state/particles.hpp"
#include "sdpd/system/sub_step.hpp"
#include <string_view>

namespace mesobridge::sdpd {

/// What an integrator cannot do without, each with the reason; empty where it can.
struct Needs {
  std::string_view noise, internal_energies, no_internal_energies, densities;
};

/// A way to integrate the pairs' fluctuation and dissipation (sdpd/README.md, Eq. (S11)) over dt at fixed
/// positions and densities. Each is a file of this room, which scheme/list.cpp lists.
///
/// A sweep needs the caloric expansions of thermodynamics_from_entropy, and leaves T behind the energies
/// (call thermodynamics_from_energy). `second` draws other random numbers: for the second sweep of a step.
struct PairIntegrator {
  std::string name;    ///< in scenes and options
  std::string summary; ///< what it does with a pair, a few words
  void (*sweep)(System& system, double dt, bool second);
  std::vector<Conserved> conserves = {Conserved::positions, Conserved::momentum, Conserved::energy};
  std::vector<SweepStream> noise = {fluctuation_noise};
  PairScheme of_heat = PairScheme::ssa; ///< how conduction goes with it, which is always pair after pair
  bool short_steps_only = false;        ///< its laws are wrong by more and more as time steps grow
  Needs needs = {};
};

} // namespace mesobridge::sdpd
