#include "md/error.hpp"
#include "md/rank_launcher.hpp"
#include "scratch_directory.hpp"
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mesobridge::md::test {
namespace {

int on_ranks(int ranks, std::string const& script) {
  return run_on_ranks(ranks, {"/bin/sh", "-c", script});
}

TEST(RankLauncher, GivesTheExitCodeOfTheProgram) {
  int cases = 0;
  for (int code : {0, 2, 3, 4}) {
    EXPECT_EQ(on_ranks(2, fmt::format("exit {}", code)), code);
    ++cases;
  }
  EXPECT_EQ(cases, 4);
  EXPECT_EQ(on_ranks(2, "test $OMPI_COMM_WORLD_RANK = 0 || exit 5"), 5) << "of whichever rank fails";
}

TEST(RankLauncher, StartsThatManyRanks) {
  auto const file = std::filesystem::temp_directory_path() / fmt::format("mesobridge-ranks-{}", ::getpid());
  EXPECT_EQ(on_ranks(3, fmt::format("echo $OMPI_COMM_WORLD_RANK/$OMPI_COMM_WORLD_SIZE >> {}", file.string())),
            0);
  std::ifstream lines(file);
  std::multiset<std::string> found;
  for (std::string line; lines >> line;)
    found.insert(line);
  EXPECT_EQ(found, (std::multiset<std::string>{"0/3", "1/3", "2/3"}));
  std::filesystem::remove(file);
}

TEST(RankLauncher, AnInterruptReachesTheRanksAndGivesThemTimeToEnd) {
  auto const file =
      std::filesystem::temp_directory_path() / fmt::format("mesobridge-interrupt-{}", ::getpid());
  pid_t const launcher = fork();
  if (launcher == 0) {
    auto const script = fmt::format("trap 'sleep 2; echo saved >> {0}; exit 0' INT; echo up >> {0}; "
                                    "while :; do sleep 0.1; done",
                                    file.string());
    _exit(on_ranks(2, script));
  }
  auto const lines = [&](std::string const& wanted) {
    std::ifstream stream(file);
    int count = 0;
    for (std::string line; stream >> line;)
      count += line == wanted;
    return count;
  };
  for (int k = 0; k < 100 && lines("up") < 2; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  ASSERT_EQ(lines("up"), 2);
  kill(launcher, SIGINT);
  int status = 0;
  waitpid(launcher, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(lines("saved"), 2);
  std::filesystem::remove(file);
}

TEST(RankLauncher, AMissingMpirunIsAClearError) {
  std::string const path = std::getenv("PATH");
  tests::ScratchDirectory const empty;
  setenv("PATH", empty.path().c_str(), 1);
  try {
    on_ranks(2, "exit 0");
    ADD_FAILURE() << "no error";
  } catch (EnvironmentError const& error) {
    EXPECT_NE(std::string(error.what()).find("openmpi-bin"), std::string::npos);
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_THROW(on_ranks(0, "exit 0"), InputError);
  EXPECT_THROW(run_on_ranks(2, {}), InputError);
}

TEST(RankLauncher, KnowsWhetherItIsOnRanksAlready) {
  EXPECT_FALSE(already_on_ranks());
  setenv("OMPI_COMM_WORLD_SIZE", "2", 1);
  EXPECT_TRUE(already_on_ranks());
  unsetenv("OMPI_COMM_WORLD_SIZE");
}

} // namespace
} // namespace mesobridge::md::test
