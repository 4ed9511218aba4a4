#include "md/error.hpp"
#include "workflows/progress.hpp"
#include "workflows/terminal.hpp"
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

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

/// The last line that a bar of this title shows on a terminal of so many columns.
std::string bar_at(std::string const& title, std::size_t columns, std::string const& note = "") {
  setenv("COLUMNS", std::to_string(columns).c_str(), 1);
  std::ostringstream out;
  Stopwatch watch;
  std::string line;
  {
    Progress progress(Progress::Style::bar, out, title, 200, [&watch] { return watch.time; });
    progress.update(0);
    watch.time += 50s;
    progress.update(50, note);
    line = out.str().substr(std::string("\r\033[K").size());
  }
  unsetenv("COLUMNS");
  return line;
}

TEST(ProgressBar, FitsTheTerminal) {
  if (isatty(2))
    GTEST_SKIP() << "the terminal's own width is taken";
  EXPECT_EQ(bar_at("sampling", 80), "sampling [#######.......................]  25 % · 2 min 30 s left");
  EXPECT_EQ(bar_at("Schmelze für Köln", 60), "Schmelze für Köln [###............]  25 % · 2 min 30 s left");
  EXPECT_EQ(bar_at("sampling", 24), " 25 % · 2 min 30 s left");
  int cases = 0;
  for (std::string const title :
       {"sampling", "Argon bei 1000 K, wie im fünften Kapitel der Dissertation über Größe",
        "氩气在一千开尔文下的平衡模拟运行", "two\nlines\tand a \033[31mcolour", ""})
    for (std::size_t columns = 1; columns <= 200; ++columns) {
      auto const line = bar_at(title, columns, "state 3 of 60");
      EXPECT_LT(display_width(line), std::max<std::size_t>(columns, 2)) << columns << " " << line;
      EXPECT_EQ(line.find_first_of("\n\t\033"), std::string::npos);
      ++cases;
    }
  EXPECT_EQ(cases, 1000);
}

TEST(Terminal, KnowsHowWideTextsAre) {
  EXPECT_EQ(display_width("Köln ·…"), 7u);
  EXPECT_EQ(display_width("氩气"), 4u);
  EXPECT_EQ(display_width("e\u0301"), 1u);  // an accent of its own
  EXPECT_EQ(display_width("\xff\xfe"), 2u); // no UTF-8
  EXPECT_EQ(fitted("Größe", 4), "Grö…");
  EXPECT_EQ(fitted("氩气体", 4), "氩…");
  EXPECT_EQ(fitted("abc", 3), "abc");
  EXPECT_EQ(wrapped("one two three", 7, 0), "one two\nthree");
  EXPECT_EQ(wrapped("one two\nthree", 10, 4), "one\n    two\n    three");
  EXPECT_EQ(wrapped("extraordinarily", 5, 0), "extraordinarily");
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
  EXPECT_EQ(duration_text(12.2 * 86400), "12 days");
  EXPECT_EQ(duration_text(4e18), "1.27e+11 years");
  EXPECT_THROW(Progress(Progress::Style::bar, out, "nothing", 0), InputError);
}

} // namespace

} // namespace mesobridge::workflows
