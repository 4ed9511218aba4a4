#pragma once
#include <array>
#include <csignal>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace mesobridge::md {

/// What a child process gets beside its words.
struct ChildSettings {
  std::vector<std::string> variables;  ///< "NAME=value", in its environment in place of ours of that name
  std::optional<int> descriptor;       ///< stays open in the child, whatever its flags say here
  std::optional<sigset_t> signal_mask; ///< this thread's own unless given
  std::optional<std::array<int, 3>> streams; ///< descriptors of its standard input, output and error
};

/// Exit code of a child whose program could not be executed.
inline constexpr int not_executed = 127;

/// Starts a program (argv[0], a path) that lives no longer than the thread which calls this: it gets SIGTERM
/// then. Its process group is its own, so that Ctrl-C reaches it by our hand alone; SIGINT and SIGTERM end it
/// unless it catches them, from its first moment on; its standard input is empty and its output goes where
/// ours goes, unless they are given. It does not take itself for a part of this process's MPI world. Throws
/// EnvironmentError when there can be no further process.
pid_t start_child(std::vector<std::string> argv, ChildSettings const& settings);

/// The file of a program that can be executed: a path, or a name on PATH.
std::optional<std::string> program_file(std::string const& name);

/// What a shell makes of a status that waitpid tells: the exit code, or 128 + the signal.
int exit_code_of(int wait_status);

} // namespace mesobridge::md
