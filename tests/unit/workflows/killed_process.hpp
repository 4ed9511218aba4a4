#pragma once
#include "md/child_process.hpp"
#include <chrono>
#include <csignal>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <vector>

namespace mesobridge::tests {

/// Starts the program, waits and sends it a signal; its status as waitpid tells it.
template <class Wait>
int killed(Wait const& wait, int signal, std::vector<std::string> command) {
  pid_t const child = md::start_child(std::move(command), {});
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
