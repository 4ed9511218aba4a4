#include "md/error.hpp"
#include "workflows/progress.hpp"
#include <gtest/gtest.h>
#include <sstream>

namespace mesobridge::workflows {

namespace {

using namespace std::chrono_literals;

struct Stopwatch {
  Progress::Clock::time_point time{};
  Progress::Clock::time_point operator()() const { return time; }
};

struct ProgressTest : testing::Test {
  std::ostringstream out;
  Stopwatch watch;
  Progress start(Progress::Style style) {
    return Progress(style, out, "sampling", 200, [this] { return watch.time; });
  }
};

TEST_F(ProgressTest, LinesComeEveryTenSeconds) {
  auto progress = start(Progress::Style::lines);
  progress.update(0);
  for (int second = 1; second <= 25; ++second) {
    watch.time += 1s;
    progress.update(2.0 * second, "state 3 of 60");
  }
  EXPECT_EQ(out.str(), "sampling: 10 % · 1 min 30 s left · state 3 of 60\n"
                       "sampling: 20 % · 1 min 20 s left · state 3 of 60\n");
  progress.finish();
  progress.update(200);
  EXPECT_TRUE(out.str().ends_with("\nsampling: done in 25 s\n"));
}

TEST_F(ProgressTest, TheBarIsRedrawnInPlaceAndRemoved) {
  {
    auto progress = start(Progress::Style::bar);
    progress.update(0);
    watch.time += 50s;
    progress.update(50);
    progress.update(51); // too soon
  }
  EXPECT_EQ(out.str(), "\r\033[Ksampling [#######.......................]  25 % · 2 min 30 s left\r\033[K");
}

TEST_F(ProgressTest, AResumedRunIsNotTakenForAFastOne) {
  auto progress = start(Progress::Style::lines);
  watch.time += 1s;
  progress.update(150);
  watch.time += 10s;
  progress.update(160);
  EXPECT_EQ(out.str(), "sampling: 80 % · 40 s left\n");
  out.str("");
  auto bar = start(Progress::Style::bar);
  watch.time += 1s;
  bar.update(150);
  EXPECT_TRUE(out.str().ends_with(" 75 % · starting")) << out.str();
}

TEST_F(ProgressTest, QuietSaysNothing) {
  auto progress = start(Progress::Style::quiet);
  watch.time += 1h;
  progress.update(100);
  progress.finish();
  EXPECT_EQ(out.str(), "");
}

TEST_F(ProgressTest, ReportsArePlainParts) {
  auto progress = start(Progress::Style::reports);
  for (int tenth = 0; tenth <= 25; ++tenth) {
    progress.update(4.0 * tenth, "state 3 of 60");
    watch.time += 100ms;
  }
  progress.finish();
  EXPECT_EQ(out.str(), "0.200000\n0.400000\n");
}

TEST_F(ProgressTest, DurationsReadWell) {
  EXPECT_EQ(duration_text(0.4), "0 s");
  EXPECT_EQ(duration_text(59.6), "1 min 00 s");
  EXPECT_EQ(duration_text(125), "2 min 05 s");
  EXPECT_EQ(duration_text(12000), "3 h 20 min");
  EXPECT_THROW(Progress(Progress::Style::bar, out, "nothing", 0), InputError);
}

} // namespace

} // namespace mesobridge::workflows
