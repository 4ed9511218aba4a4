#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/farm.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/ranks.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <chrono>
#include <csignal>
#include <gtest/gtest.h>
#include <sstream>
#include <thread>
#include <unistd.h>

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

FarmedRun script(std::string const& text, double work = 1) {
  return {{"/bin/sh", "-c", text}, work};
}

Context quiet() {
  Context context;
  context.options.quiet = true;
  return context;
}

TEST(Farm, BeginsTheMostWorkFirst) {
  ScratchDirectory const scratch;
  auto const log = (scratch / "log").string();
  std::vector<FarmedRun> runs;
  for (int const work : {2, 5, 1, 4, 3})
    runs.push_back(script(fmt::format("printf {} >> {}", work, log), work));
  farm("digits", runs, 1, quiet());
  EXPECT_EQ(read_text_file(log), "54321");
}

TEST(Farm, RunsSoManyAtOnce) {
  ScratchDirectory const scratch;
  auto const log = (scratch / "log").string();
  std::vector<FarmedRun> const runs(5, script(fmt::format("printf + >> {0}; sleep 1; printf - >> {0}", log)));
  farm("sleepers", runs, 3, quiet());
  int running = 0, most = 0, begun = 0;
  for (char const sign : read_text_file(log)) {
    running += sign == '+' ? 1 : -1;
    begun += sign == '+';
    most = std::max(most, running);
  }
  EXPECT_EQ(most, 3);
  EXPECT_EQ(begun, 5);
}

TEST(Farm, AddsUpWhatItsRunsReport) {
  auto context = quiet();
  auto const told = std::make_shared<std::ostringstream>();
  context.reports = told; // as if this process were watched itself
  auto const to = fmt::format("> /proc/self/fd/${}", reports_variable);
  auto const reports = fmt::format("echo 0.1 {0}; printf '0.5\\n0.' {0}; sleep 4", to);
  farm("reporters", {script(reports, 3), script("sleep 4", 1)}, 2, context);
  std::istringstream lines(told->str());
  std::vector<double> parts;
  for (double part = 0; lines >> part;)
    parts.push_back(part);
  EXPECT_GT(std::count(parts.begin(), parts.end(), 0.375), 0)
      << "half of the first run, which is three quarters of the work: " << told->str();
}

/// Waits to be interrupted, which it writes to `log`; tells by `ready` that it waits.
std::string patient(std::filesystem::path const& log, std::filesystem::path const& ready) {
  return fmt::format("trap 'printf stopped >> {}; exit 130' INT; printf . >> {}; "
                     "for k in $(seq 300); do sleep 0.1; done",
                     log.string(), ready.string());
}

TEST(Farm, PassesOnTheCodeOfARunThatFailsAndStopsTheOthers) {
  ScratchDirectory const scratch;
  auto const log = scratch / "log", ready = scratch / "ready";
  auto const fails =
      fmt::format("for k in $(seq 300); do test -e {} && break; sleep 0.1; done; exit 3", ready.string());
  auto const never = fmt::format("printf begun >> {}", log.string());
  try {
    farm("one that fails", {script(patient(log, ready), 9), script(fails, 8), script(never, 1)}, 2, quiet());
    FAIL() << "no failure";
  } catch (AlreadyReported const& failure) {
    EXPECT_EQ(failure.exit_code, 3);
  }
  EXPECT_EQ(read_text_file(log), "stopped");
}

TEST(Farm, TellsOfRunsThatCouldNotTellThemselves) {
  auto const message = [](FarmedRun const& run) -> std::string {
    try {
      farm("one that crashes", {run}, 2, quiet());
    } catch (EnvironmentError const& error) {
      return error.what();
    }
    return "no failure";
  };
  EXPECT_NE(message(script("kill -SEGV $$")).find("signal 11"), std::string::npos);
  ScratchDirectory const scratch;
  auto const missing = (scratch / "program").string();
  EXPECT_NE(message({{missing}, 1}).find(fmt::format("'{}' could not be executed", missing)),
            std::string::npos);
}

TEST(Farm, PassesOnAnInterrupt) {
  ScratchDirectory const scratch;
  auto const log = scratch / "log", ready = scratch / "ready";
  catch_interrupts();
  std::jthread const user([&] {
    for (int k = 0; k < 300; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      if (std::filesystem::exists(ready) && std::filesystem::file_size(ready) == 2)
        break;
    }
    kill(getpid(), SIGINT);
  });
  std::vector<FarmedRun> const runs(3, script(patient(log, ready)));
  EXPECT_THROW(farm("interrupted", runs, 2, quiet()), Interrupted);
  catch_interrupts(); // forgets the one that came
  EXPECT_EQ(read_text_file(log), "stoppedstopped");
}

TEST(Farm, RefusesRunsWithoutWork) {
  EXPECT_THROW(farm("nothing", {script("true", 0)}, 1, quiet()), InputError);
  EXPECT_THROW(farm("nobody", {script("true")}, 0, quiet()), InputError);
}

TEST(Farm, PaysWhereTheLongestRunIsShortEnough) {
  using Work = std::vector<double>;
  EXPECT_TRUE(farming_pays(Work{1, 1, 1, 1}, 2));
  EXPECT_TRUE(farming_pays(Work{5, 2, 2, 1}, 2));
  EXPECT_FALSE(farming_pays(Work{8, 2}, 2)) << "the second core would idle";
  EXPECT_FALSE(farming_pays(Work{1}, 2));
  EXPECT_FALSE(farming_pays(Work{1, 1, 1}, 2));
  EXPECT_FALSE(farming_pays(Work{1, 1}, 1));
  EXPECT_FALSE(farming_pays(Work{}, 2));
}

} // namespace
} // namespace mesobridge::workflows
