#pragma once
#include "sdpd/barrier.hpp"
#include "sdpd/block_shares.hpp"
#include <omp.h>

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
  std::optional<Barrier> barrier;
  std::optional<BlockShares> shares;
#pragma omp parallel num_threads(threads)
  {
#pragma omp single // ends with a barrier of its own: all see what it made
    {
      barrier.emplace(omp_get_num_threads());
      shares.emplace(grid, omp_get_num_threads());
    }
    for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
      while (auto const block = shares->take(phase, omp_get_thread_num()))
        f(*block);
      if constexpr (phases == Phases::in_turn)
        barrier->wait();
    }
  }
}

} // namespace mesobridge::sdpd
