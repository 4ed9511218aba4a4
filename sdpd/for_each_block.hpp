#pragma once
#include "sdpd/barrier.hpp"
#include "sdpd/cells.hpp"
#include <atomic>
#include <memory>
#include <omp.h>
#include <optional>

namespace mesobridge::sdpd {

/// Calls f(block) for every block of the grid, phase after phase, on all threads. Within a phase threads take
/// the next block that is left. Only for functions that write to the particles of their own block.
template <class F>
void for_each_block(CellGrid const& grid, int threads, F&& f) {
  auto const begin = grid.phase_begin();
  if (threads == 1) { // the phases follow each other in the list
    for (std::size_t block = 0; block < grid.blocks().size(); ++block)
      f(block);
    return;
  }
  std::optional<Barrier> barrier;
  std::array<std::atomic<std::size_t>, 27> next;
  for (std::size_t phase = 0; phase < grid.phase_count(); ++phase)
    next[phase] = begin[phase];
#pragma omp parallel num_threads(threads)
  {
#pragma omp single // ends with a barrier of its own: all see the new one
    barrier.emplace(omp_get_num_threads());
    for (std::size_t phase = 0; phase < grid.phase_count(); ++phase) {
      for (std::size_t block;
           (block = next[phase].fetch_add(1, std::memory_order_relaxed)) < begin[phase + 1];)
        f(block);
      barrier->wait();
    }
  }
}

} // namespace mesobridge::sdpd
