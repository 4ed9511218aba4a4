#pragma once
#include <csignal>
#include <cstddef>
#include <functional>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mesobridge::tests {

/// Whether a process may follow the calls of its child; sandboxes and old systems forbid it.
inline bool may_trace() {
  pid_t const child = fork();
  if (child == 0) {
    if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0)
      _exit(1);
    raise(SIGSTOP);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFSTOPPED(status))
    return false;
  __ptrace_syscall_info info{};
  bool const may =
      ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL) == 0 &&
      ptrace(PTRACE_SYSCALL, child, nullptr, nullptr) == 0 && waitpid(child, &status, 0) == child &&
      WIFSTOPPED(status) && ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof info, &info) > 0;
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  return may;
}

/// Runs `work` in a process of its own and kills that (SIGKILL) right before its `last`-th call of the system
/// that changes a file: write, pwrite64, ftruncate, rename or unlink. True when it came to its end before.
inline bool ends_before_change(std::size_t last, std::function<void()> const& work) {
  pid_t const child = fork();
  if (child == 0) {
    ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    raise(SIGSTOP);
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
  for (std::size_t changes = 0;;) {
    ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
    waitpid(child, &status, 0);
    if (!WIFSTOPPED(status))
      return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    __ptrace_syscall_info info{};
    ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof info, &info);
    if (info.op != PTRACE_SYSCALL_INFO_ENTRY)
      continue;
    auto const call = info.entry.nr;
    bool const changes_a_file = call == SYS_write || call == SYS_pwrite64 || call == SYS_ftruncate ||
                                call == SYS_rename || call == SYS_unlink;
    if (changes_a_file && ++changes == last) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return false;
    }
  }
}

} // namespace mesobridge::tests
