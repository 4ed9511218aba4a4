#include "sdpd/for_each_block.hpp"
#include "sdpd/team.hpp"
#include <gtest/gtest.h>
#include <mutex>
#include <set>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace mesobridge::sdpd {
namespace {

using std::chrono::milliseconds;

std::chrono::microseconds processor_time() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::chrono::seconds(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         std::chrono::microseconds(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

TEST(Team, HelpsWithATaskUnderNumbersOfItsOwn) {
  int cases = 0;
  for (int const threads : {1, 4, 2, 7, 3}) { // fewer than before, too
    std::mutex lock;
    std::set<int> numbers;
    std::set<std::thread::id> ids;
    for (int repeat = 0; repeat < 50; ++repeat) {
      std::multiset<int> now;
      with_team(threads, [&](int thread) {
        std::scoped_lock const alone(lock);
        now.insert(thread), numbers.insert(thread), ids.insert(std::this_thread::get_id());
      });
      ASSERT_EQ(now.count(0), 1u); // its own thread is always there
      ASSERT_EQ(now.size(), std::set(now.begin(), now.end()).size());
    }
    EXPECT_LE(*numbers.rbegin(), threads - 1);
    EXPECT_LE(ids.size(), static_cast<std::size_t>(threads));
    EXPECT_TRUE(ids.contains(std::this_thread::get_id()));
    ++cases;
  }
  EXPECT_EQ(cases, 5);
}

TEST(Team, ComesWhenTheTaskIsLongEnough) {
  std::atomic<int> present = 0;
  with_team(4, [&](int) {
    ++present;
    auto const give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (present < 4 && std::chrono::steady_clock::now() < give_up)
      std::this_thread::yield();
  });
  EXPECT_EQ(present, 4);
}

TEST(Team, GivesEachIndexToOneThread) {
  int cases = 0;
  for (std::size_t const count : {0, 1, 5, 1000})
    for (int const threads : {1, 2, 3, 8, 100}) {
      std::vector<int> times(count);
      for (int repeat = 0; repeat < 20; ++repeat)
        for_each_index(count, threads, [&](std::size_t k) { ++times[k]; });
      EXPECT_EQ(times, std::vector<int>(count, 20));
      ++cases;
    }
  EXPECT_EQ(cases, 20);
}

TEST(Team, WaitsForThoseWhoHaveBegun) {
  for (std::size_t slow = 0; slow < 3; ++slow) {
    std::atomic<int> finished = 0;
    for_each_index(3, 3, [&](std::size_t k) {
      if (k == slow)
        std::this_thread::sleep_for(milliseconds(20)); // longer than the others spin
      ++finished;
    });
    EXPECT_EQ(finished, 3);
  }
}

TEST(Team, BelongsToOneThread) {
  std::vector<std::jthread> masters;
  std::atomic<int> sum = 0;
  for (int m = 0; m < 3; ++m)
    masters.emplace_back([&] {
      for (int repeat = 0; repeat < 200; ++repeat)
        for_each_index(10, 2, [&](std::size_t k) { sum += static_cast<int>(k); });
    });
  masters.clear();
  EXPECT_EQ(sum, 3 * 200 * 45);
}

// A thread that waits for long leaves its processor to others.
TEST(Team, SleepsWhileItWaitsForLong) {
  for_each_index(4, 4, [](std::size_t) {});
  auto const before = processor_time();
  for_each_index(4, 4, [](std::size_t k) {
    if (k == 3)
      std::this_thread::sleep_for(milliseconds(300));
  });
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_LT(processor_time() - before, milliseconds(60)); // 1.2 s if the team span
}

// Whoever is late or slow, a phase begins when all blocks of the one before are done, and each is done once.
TEST(ForEachBlock, KeepsThePhasesApart) {
  CellGrid const grid(Box{{11.5, 13.2, 17.9}}, 1);
  auto const begin = grid.phase_begin();
  int cases = 0;
  for (int const threads : {1, 2, 4, 7})
    for (int repeat = 0; repeat < 20; ++repeat, ++cases) {
      std::vector<std::atomic<int>> done(grid.phase_count());
      std::vector<int> times(grid.blocks().size());
      std::atomic<int> early = 0;
      for_each_block(grid, threads, [&](std::size_t block) {
        auto const phase =
            static_cast<std::size_t>(std::upper_bound(begin.begin(), begin.end(), block) - begin.begin()) - 1;
        for (std::size_t p = 0; p < phase; ++p)
          early += done[p] != static_cast<int>(begin[p + 1] - begin[p]);
        if (block == begin[phase] + 1 && repeat % 10 == 0)
          std::this_thread::sleep_for(milliseconds(1)); // the others sleep meanwhile
        ++times[block], ++done[phase];
      });
      ASSERT_EQ(early, 0);
      ASSERT_EQ(times, std::vector<int>(times.size(), 1));
    }
  EXPECT_EQ(cases, 80);
  EXPECT_EQ(grid.phase_count(), 8u);
}

} // namespace
} // namespace mesobridge::sdpd
