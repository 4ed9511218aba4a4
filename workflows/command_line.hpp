#pragma once
#include "workflows/command.hpp"
#include <exception>

namespace mesobridge::workflows {

/// Exit codes of the program.
enum ExitCode : int { done = 0, bad_input = 2, physical_failure = 3, bad_environment = 4, interrupted = 130 };

/// Finds the command, parses its options, runs it and prints its result: one JSON object (--json) or text on
/// stdout, everything else on stderr. Returns the exit code; throws nothing.
int run_command_line(std::vector<std::string> const& arguments, std::vector<Command> const& commands);

/// The exit code and the message that an exception stands for.
struct Failure {
  ExitCode code;
  std::string message;
};
Failure describe(std::exception_ptr error);

} // namespace mesobridge::workflows
