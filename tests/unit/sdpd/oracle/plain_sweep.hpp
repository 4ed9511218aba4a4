#pragma once
#include "sdpd/fluctuation/sweep.hpp"

namespace mesobridge::sdpd {

/// All blocks by sweep_block(weights, block, sweep, counts, failure).
template <class Law, class SweepBlock>
void sweep_plainly(System& system, Law const& law, double dt, SweepNoise const& noise, PairCounts& total,
                   SweepBlock const& sweep_block) {
  Sweep<Law> const sweep{law, dt, noise};
  with_weights(system.kernel, law, [&](auto const& weights) {
    sweep_all_blocks<Law>(system, total, [&](std::size_t block, PairCounts& counts, Failure& failure) {
      sweep_block(weights, block, sweep, counts, failure);
    });
  });
}

/// A pair's step, which may leave the equation of state: says so of the particle with this id. Returns
/// whether it was made.
template <class Step>
bool tried(std::uint32_t id, Failure& failure, Step const& step) {
  try {
    step();
  } catch (PhysicsError const& error) {
    failure.report(id, error.what());
    return false;
  }
  return true;
}

} // namespace mesobridge::sdpd
