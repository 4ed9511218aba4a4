#pragma once
#include <chrono>
#include <csignal>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace mesobridge::tests {

/// Starts the program, waits and sends it a signal; its status as waitpid tells it.
template <class Wait>
int killed(Wait const& wait, int signal, std::vector<std::string> command) {
  std::vector<char*> argv;
  for (auto& word : command)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t const child = fork();
  if (child == 0) {
    execv(argv[0], argv.data());
    _exit(127);
  }
  wait();
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

inline int killed_after(std::chrono::microseconds delay, int signal,
                        std::vector<std::string> const& command) {
  return killed([&] { std::this_thread::sleep_for(delay); }, signal, command);
}

} // namespace mesobridge::tests
