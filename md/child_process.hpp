#pragma once
#include <csignal>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mesobridge::md {

/// What a child process gets beside its words.
struct ChildSettings {
  std::vector<std::string> variables;  ///< "NAME=value", added to its environment
  std::optional<int> descriptor;       ///< stays open in the child, whatever its flags say here
  std::optional<sigset_t> signal_mask; ///< this thread's own unless given
};

/// Starts a program (argv[0], a path) that lives no longer than the thread which calls this: it gets SIGTERM
/// then. Its process group is its own, so that Ctrl-C reaches it by our hand alone; its standard input is
/// empty; its output goes where ours goes. It does not take itself for a part of this process's MPI world.
/// A program that cannot be executed ends with the exit code 127. Throws EnvironmentError when there can be
/// no further process.
pid_t start_child(std::vector<std::string> argv, ChildSettings const& settings);

} // namespace mesobridge::md
