#include "sdpd/neighbours/block_shares.hpp"
#include <gtest/gtest.h>
#include <mutex>
#include <set>
#include <thread>

namespace mesobridge::sdpd {
namespace {

CellGrid grid() {
  return {Box{{11.5, 13.2, 17.9}}, 1};
}

/// Cell pairs of the blocks.
std::size_t work(CellGrid const& grid, std::vector<std::size_t> const& blocks) {
  std::size_t sum = 0;
  for (std::size_t const block : blocks)
    sum += grid.blocks()[block].pairs.size();
  return sum;
}

/// The blocks of a phase by the threads that take them, in turn.
std::vector<std::vector<std::size_t>> taken_in_turn(BlockShares& shares, std::size_t phase, int threads) {
  std::vector<std::vector<std::size_t>> taken(static_cast<std::size_t>(threads));
  for (bool some = true; some;) {
    some = false;
    for (int thread = 0; thread < threads; ++thread)
      if (auto const block = shares.take(phase, thread)) {
        taken[static_cast<std::size_t>(thread)].push_back(*block);
        some = true;
      }
  }
  return taken;
}

TEST(BlockShares, HoldEachBlockOfAPhaseOnce) {
  auto const cells = grid();
  int cases = 0;
  for (int const threads : {1, 2, 3, 7, 100}) {
    BlockShares shares(cells, threads);
    for (std::size_t phase = 0; phase < cells.phase_count(); ++phase, ++cases) {
      std::set<std::size_t> all;
      std::size_t count = 0;
      for (auto const& blocks : taken_in_turn(shares, phase, threads))
        all.insert(blocks.begin(), blocks.end()), count += blocks.size();
      std::size_t const begin = cells.phase_begin()[phase], end = cells.phase_begin()[phase + 1];
      EXPECT_EQ(count, end - begin);
      EXPECT_EQ(all.size(), count);
      EXPECT_EQ(*all.begin(), begin);
      EXPECT_EQ(*all.rbegin(), end - 1);
    }
  }
  EXPECT_EQ(cases, 5 * 8);
}

TEST(BlockShares, AreOfTheSameSizeAndThoseOfTheSlowAreTakenFromTheirEnd) {
  auto const cells = grid();
  BlockShares shares(cells, 2);
  for (std::size_t phase = 0; phase < cells.phase_count(); ++phase) {
    std::size_t const begin = cells.phase_begin()[phase], end = cells.phase_begin()[phase + 1];
    std::vector<std::size_t> own, others;
    while (auto const block = shares.take(phase, 1)) // the other thread does not come
      (own.empty() || *block == own.back() + 1 ? own : others).push_back(*block);
    ASSERT_EQ(own.size() + others.size(), end - begin);
    EXPECT_EQ(own.back(), end - 1) << "its own ones first";
    EXPECT_EQ(others.front() + 1, own.front());
    EXPECT_EQ(others.back(), begin);
    double const mine = double(work(cells, own)), all = mine + double(work(cells, others));
    EXPECT_NEAR(mine / all, 0.5, 0.06);
  }
}

TEST(BlockShares, ServeThreadsThatHurry) {
  auto const cells = grid();
  for (int repeat = 0; repeat < 200; ++repeat) {
    BlockShares shares(cells, 4);
    std::mutex lock;
    std::multiset<std::size_t> all;
    {
      std::vector<std::jthread> threads;
      for (int thread = 0; thread < 4; ++thread)
        threads.emplace_back([&, thread] {
          while (auto const block = shares.take(0, thread)) {
            std::scoped_lock const alone(lock);
            all.insert(*block);
          }
        });
    }
    ASSERT_EQ(all.size(), cells.phase_begin()[1]);
    ASSERT_EQ(std::set<std::size_t>(all.begin(), all.end()).size(), all.size());
  }
}

} // namespace
} // namespace mesobridge::sdpd
