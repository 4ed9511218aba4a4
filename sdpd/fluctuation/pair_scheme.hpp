#pragma once
namespace mesobridge::sdpd {

/// What pairs that are worked on one after the other do with a step.
enum class PairScheme {
  ssa, ///< make it
  ams, ///< not when it would lead an internal energy out of the equation of state
  ems  ///< that, and put it to a Metropolis test, which makes the invariant measure exact at any dt
};

} // namespace mesobridge::sdpd
