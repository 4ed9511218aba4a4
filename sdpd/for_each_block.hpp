#pragma once
#include "sdpd/block_shares.hpp"
#include "sdpd/team.hpp"
#include "sdpd/waiting.hpp"

namespace mesobridge::sdpd {

/// How far a phase is, of which the next must see all that was done. It does not ask who did it: a thread
/// that took no block is not waited for.
struct alignas(64) PhaseProgress {
  std::atomic<std::size_t> done = 0;
  Signal is_complete = 0;

  void add(std::size_t blocks, std::size_t all) {
    if (blocks > 0 && done.fetch_add(blocks, std::memory_order_acq_rel) + blocks == all)
      change_to(is_complete, 1);
  }
  void wait() const { wait_while(is_complete, 0); }
};

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
  auto const begin = grid.phase_begin();
  BlockShares shares(grid, threads);
  std::vector<PhaseProgress> progress(grid.phase_count());
  with_team(threads, [&](int thread) {
    for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
      std::size_t const all = begin[phase + 1] - begin[phase];
      std::size_t blocks = 0;
      for (; auto const block = shares.take(phase, thread); ++blocks)
        f(*block);
      if (phases == Phases::at_once || all == 0)
        continue;
      progress[phase].add(blocks, all);
      progress[phase].wait();
    }
  });
}

} // namespace mesobridge::sdpd
