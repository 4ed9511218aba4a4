#pragma once
#include "sdpd/neighbours/cells.hpp"
#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace mesobridge::sdpd {

/// The blocks of a grid while threads take them, phase after phase. Each thread begins a phase with a share
/// of its own, which lies in the same part of the box in every phase, so that its particles stay in its
/// cache; who has none left takes the last ones of the others. Who works on a block changes nothing in the
/// results.
class BlockShares {
 public:
  BlockShares(CellGrid const& grid, int threads)
      : threads_(static_cast<std::size_t>(threads)), left_(grid.phase_count() * threads_) {
    for (std::size_t phase = 0; phase < grid.phase_count(); ++phase)
      deal(grid, phase);
  }

  /// The next block of the phase for that thread; none when all are taken.
  std::optional<std::size_t> take(std::size_t phase, int thread) {
    Left* const shares = &left_[phase * threads_];
    auto const own = static_cast<std::size_t>(thread);
    if (auto const block = take_from(shares[own], Side::first))
      return block;
    for (std::size_t k = 1; k < threads_; ++k)
      if (auto const block = take_from(shares[(own + k) % threads_], Side::last))
        return block;
    return std::nullopt;
  }

 private:
  enum class Side { first, last };

  /// Blocks begin ... end-1 that are left of a share, in one word that is changed at once: begin in its upper
  /// half. Each has a cache line of its own.
  struct alignas(64) Left {
    std::atomic<std::uint64_t> range;
  };
  static std::uint64_t range(std::size_t begin, std::size_t end) { return std::uint64_t{begin} << 32 | end; }

  /// Shares with about the same number of cell pairs: a block belongs to the share in which the middle of its
  /// work lies.
  void deal(CellGrid const& grid, std::size_t phase) {
    std::size_t const begin = grid.phase_begin()[phase], end = grid.phase_begin()[phase + 1];
    auto const work = [&](std::size_t block) { return grid.blocks()[block].pairs.size(); };
    std::size_t all = 0, dealt = 0, block = begin;
    for (std::size_t k = begin; k < end; ++k)
      all += work(k);
    for (std::size_t share = 0; share < threads_; ++share) {
      std::size_t const first = block;
      for (; block < end && (2 * dealt + work(block)) * threads_ < 2 * all * (share + 1); ++block)
        dealt += work(block);
      left_[phase * threads_ + share].range = range(first, block);
    }
  }

  static std::optional<std::size_t> take_from(Left& left, Side side) {
    for (std::uint64_t now = left.range.load(std::memory_order_relaxed);;) {
      std::size_t const begin = now >> 32, end = now & 0xffffffffu;
      if (begin >= end)
        return std::nullopt;
      bool const first = side == Side::first;
      auto const rest = first ? range(begin + 1, end) : range(begin, end - 1);
      if (left.range.compare_exchange_weak(now, rest, std::memory_order_relaxed))
        return first ? begin : end - 1;
    }
  }

  std::size_t threads_;
  std::vector<Left> left_; ///< thread by thread, phase after phase
};

} // namespace mesobridge::sdpd
