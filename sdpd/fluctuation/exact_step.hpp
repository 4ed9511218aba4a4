#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/pair_states.hpp"
#include "sdpd/state/pair_counts.hpp"

namespace mesobridge::sdpd {

/// Whether the scheme makes a step that brings these heats to a pair; counts what it does not make.
/// exponent(proposed) is that of the Metropolis test, which `uniform` in [0, 1) decides. Throws PhysicsError
/// for SSA when the step leaves the equation of state.
template <class Exponent>
bool makes_step(PairScheme scheme, PairStates const& pair, std::array<double, 2> heat, double uniform,
                PairCounts& counts, Exponent const& exponent) {
  PairStates::States proposed;
  try {
    proposed = pair.with(heat[0], heat[1]);
  } catch (PhysicsError const&) {
    if (scheme == PairScheme::ssa)
      throw;
    ++counts.out_of_domain;
    return false;
  }
  if (scheme == PairScheme::ems && !(uniform < std::exp(exponent(proposed)))) {
    ++counts.metropolis;
    return false;
  }
  return true;
}

} // namespace mesobridge::sdpd
