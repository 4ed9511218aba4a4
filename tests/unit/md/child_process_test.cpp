#include "md/child_process.hpp"
#include "md/error.hpp"
#include "scratch_directory.hpp"
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mesobridge::md::test {
namespace {

/// Where a child finds a descriptor of ours.
std::string out_of(int descriptor) {
  return fmt::format("OUT=/proc/self/fd/{}", descriptor);
}

/// What a shell script writes to $OUT, and its exit code.
struct Outcome {
  std::string text;
  int code;
};
Outcome run_script(std::string const& script) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw EnvironmentError("no pipe");
  pid_t const child =
      start_child({"/bin/sh", "-c", script},
                  {.variables = {out_of(ends[1])}, .descriptor = ends[1], .signal_mask = std::nullopt});
  close(ends[1]);
  Outcome outcome;
  char buffer[256];
  for (ssize_t size = 0; (size = read(ends[0], buffer, sizeof buffer)) > 0;)
    outcome.text.append(buffer, std::size_t(size));
  close(ends[0]);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  outcome.code = WEXITSTATUS(status);
  return outcome;
}

TEST(ChildProcess, GetsItsVariablesAndItsDescriptorAndNothingToRead) {
  auto const [text, code] = run_script("read word; echo \"read $word\" > $OUT; exit 7");
  EXPECT_EQ(text, "read \n");
  EXPECT_EQ(code, 7);
}

TEST(ChildProcess, IsNoPartOfThisMpiWorldAndLeadsAGroupOfItsOwn) {
  setenv("PMIX_RANK", "0", 1), setenv("MESOBRIDGE_TEST_KEPT", "kept", 1);
  auto const [text, code] = run_script(
      "echo \"$PMIX_RANK-$MESOBRIDGE_TEST_KEPT\" > $OUT; test $(cut -d' ' -f5 /proc/$$/stat) = $$");
  unsetenv("PMIX_RANK"), unsetenv("MESOBRIDGE_TEST_KEPT");
  EXPECT_EQ(text, "-kept\n");
  EXPECT_EQ(code, 0);
}

TEST(ChildProcess, ThatCannotBeExecutedSaysSoByItsCode) {
  tests::ScratchDirectory const empty;
  pid_t const child = start_child({(empty.path() / "program").string()}, {});
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 127);
  EXPECT_THROW(start_child({}, {}), InputError);
}

TEST(ChildProcess, IsFoundByItsNameOrItsPath) {
  auto const found = program_file("sh");
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->ends_with("/sh"));
  EXPECT_EQ(program_file(*found), found);
  for (char const* name : {"mesobridge-no-such-program", "/tmp", "/dev/null"})
    EXPECT_FALSE(program_file(name)) << name;
}

TEST(ChildProcess, GetsItsOwnVariableAndNotAnInheritedOne) {
  setenv("OUT", "/dev/null", 1);
  auto const [text, code] = run_script("echo here > $OUT");
  unsetenv("OUT");
  EXPECT_EQ(text, "here\n");
  EXPECT_EQ(code, 0);
}

/// Reads until the text is there or the other end is closed; gives up after 20 s.
bool read_until(int descriptor, std::string& text, std::string const& wanted) {
  for (pollfd end{.fd = descriptor, .events = POLLIN, .revents = 0}; poll(&end, 1, 20000) == 1;) {
    char letter = 0;
    if (read(descriptor, &letter, 1) != 1)
      return wanted.empty(); // closed
    text += letter;
    if (!wanted.empty() && text.ends_with(wanted))
      return true;
  }
  return false;
}

TEST(ChildProcess, DiesWithItsParent) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  pid_t const parent = fork();
  if (parent == 0) {
    try {
      start_child(
          {"/bin/sh", "-c",
           "trap 'echo asked > $OUT; exit' TERM; echo up > $OUT; for k in $(seq 400); do sleep 0.1; done"},
          {.variables = {out_of(ends[1])}, .descriptor = ends[1], .signal_mask = std::nullopt});
      for (;;)
        pause();
    } catch (...) {
    }
    _exit(1);
  }
  close(ends[1]);
  std::string text;
  EXPECT_TRUE(read_until(ends[0], text, "up\n"));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(read_until(ends[0], text, "")) << "the child has ended, too";
  close(ends[0]);
  EXPECT_EQ(text, "up\nasked\n");
}

TEST(ChildProcess, IsStoppedByASignalFromItsFirstMomentOn) {
  struct sigaction flag {
  }, before{};
  flag.sa_handler = [](int) {};
  sigaction(SIGINT, &flag, &before);
  for (int repeat = 0; repeat < 50; ++repeat) {
    pid_t const child = start_child({"/bin/sh", "-c", "sleep 20"}, {});
    kill(child, SIGINT); // before or after it has become a shell
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << repeat;
    ASSERT_EQ(WTERMSIG(status), SIGINT);
  }
  sigaction(SIGINT, &before, nullptr);
}

} // namespace
} // namespace mesobridge::md::test
