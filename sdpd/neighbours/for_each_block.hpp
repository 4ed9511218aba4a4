#pragma once
#include "sdpd/neighbours/block_shares.hpp"
#include "sdpd/threads/barrier.hpp"
#include "sdpd/threads/team.hpp"

namespace mesobridge::sdpd {

enum class Phases { in_turn, at_once };

/// Calls f(block) for every block of the grid on all threads: phase after phase for functions that write to
/// the particles of their own block, all phases at once for those that only read them. A block mostly
/// comes to the same thread.
template <Phases phases = Phases::in_turn, class F>
void for_each_block(CellGrid const& grid, int threads, F&& f) {
  if (threads == 1) { // the phases follow each other in the list
    for (std::size_t block = 0; block < grid.blocks().size(); ++block)
      f(block);
    return;
  }
  Barrier barrier(threads);
  BlockShares shares(grid, threads);
  on_threads(threads, [&](int thread) {
    for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
      while (auto const block = shares.take(phase, thread))
        f(*block);
      if (phases == Phases::in_turn && phase + 1 < grid.phase_count())
        barrier.wait();
    }
  });
}

} // namespace mesobridge::sdpd
