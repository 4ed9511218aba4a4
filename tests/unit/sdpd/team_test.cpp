#include "sdpd/threads/barrier.hpp"
#include "sdpd/threads/team.hpp"
#include <gtest/gtest.h>
#include <set>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace mesobridge::sdpd {
namespace {

using std::chrono::milliseconds;

TEST(Team, CallsATaskOnceOnEachOfItsThreads) {
  int cases = 0;
  for (int const threads : {1, 4, 2, 7, 3}) { // fewer than before, too
    std::vector<std::atomic<int>> calls(static_cast<std::size_t>(threads));
    std::vector<std::thread::id> ids(calls.size());
    for (int repeat = 0; repeat < 100; ++repeat)
      on_threads(threads, [&](int thread) {
        ++calls[static_cast<std::size_t>(thread)];
        ids[static_cast<std::size_t>(thread)] = std::this_thread::get_id();
      });
    for (auto const& of_one : calls)
      EXPECT_EQ(of_one, 100);
    EXPECT_EQ(ids[0], std::this_thread::get_id());
    EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), ids.size());
    ++cases;
  }
  EXPECT_EQ(cases, 5);
}

TEST(Team, GivesEachIndexToOneThread) {
  int cases = 0;
  for (std::size_t const count : {0, 1, 5, 1000})
    for (int const threads : {1, 2, 3, 8}) {
      std::vector<int> times(count);
      for_each_index(count, threads, [&](std::size_t k) { ++times[k]; });
      EXPECT_EQ(times, std::vector<int>(count, 1));
      ++cases;
    }
  EXPECT_EQ(cases, 16);
}

TEST(Team, WaitsForTheSlowestWhoeverThatIs) {
  for (int slow = 0; slow < 3; ++slow) {
    std::atomic<int> finished = 0;
    on_threads(3, [&](int thread) {
      if (thread == slow)
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
        on_threads(2, [&](int thread) { sum += thread; });
    });
  masters.clear();
  EXPECT_EQ(sum, 600);
}

TEST(Barrier, LetsNobodyIntoTheNextPhaseBeforeAllHaveLeftTheLast) {
  constexpr int threads = 4, phases = 300;
  Barrier barrier(threads);
  std::array<std::atomic<int>, phases> arrived{};
  std::atomic<int> early = 0;
  on_threads(threads, [&](int thread) {
    for (std::size_t phase = 0; phase < phases; ++phase) {
      if (phase % 100 == 50 && thread == static_cast<int>(phase / 100))
        std::this_thread::sleep_for(milliseconds(5));
      ++arrived[phase];
      barrier.wait();
      early += arrived[phase] != threads;
    }
  });
  EXPECT_EQ(early, 0);
}

// A thread that waits for long leaves its processor to others.
TEST(Team, SleepsWhileItWaitsForLong) {
  auto const processor_time = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::chrono::seconds(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           std::chrono::microseconds(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  };
  on_threads(4, [](int) {});
  auto const before = processor_time();
  on_threads(4, [](int thread) {
    if (thread == 3)
      std::this_thread::sleep_for(milliseconds(300));
  });
  std::this_thread::sleep_for(milliseconds(100));
  EXPECT_LT(processor_time() - before, milliseconds(60)); // 1.2 s if the team span
}

} // namespace
} // namespace mesobridge::sdpd
