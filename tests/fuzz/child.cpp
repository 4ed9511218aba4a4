#include "fuzz/child.hpp"
#include "workflows/command/list.hpp"
#include "workflows/command_line.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/text_file.hpp"
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace mesobridge::fuzz {
namespace {

[[noreturn]] void work(std::filesystem::path const& folder, std::vector<std::string> const& words) {
  std::filesystem::current_path(folder);
  int const out = open("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666),
            err = open("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666);
  dup2(out, STDOUT_FILENO), dup2(err, STDERR_FILENO);
  workflows::survive_failing_streams();
  int const status = workflows::run_command_line(words, workflows::commands());
  std::cout.flush(), std::cerr.flush(), std::fflush(nullptr);
  _exit(status);
}

/// Whether the process ended within the time; polls, because waiting for a child has no time limit.
bool ended_within(pid_t child, double seconds, int& status) {
  using Clock = std::chrono::steady_clock;
  auto const end = Clock::now() + std::chrono::duration<double>(seconds);
  for (auto pause = std::chrono::microseconds(200); waitpid(child, &status, WNOHANG) != child;) {
    if (Clock::now() > end)
      return false;
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::microseconds(5000));
  }
  return true;
}

} // namespace

pid_t start_in_child(std::filesystem::path const& folder, std::vector<std::string> const& words) {
  pid_t const child = fork();
  if (child == 0)
    work(folder, words);
  return child;
}

Outcome run_in_child(std::filesystem::path const& folder, std::vector<std::string> const& words,
                     double seconds, double patience) {
  pid_t const child = start_in_child(folder, words);
  Outcome outcome;
  int status = 0;
  if (!ended_within(child, seconds, status)) {
    kill(child, SIGTERM);
    if (!ended_within(child, patience, status)) {
      outcome.hung = true;
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
    }
  }
  outcome.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  for (char const* name : {"stdout.txt", "stderr.txt"})
    if (std::filesystem::exists(folder / name))
      outcome.printed += workflows::read_text_file(folder / name);
  return outcome;
}

} // namespace mesobridge::fuzz
