#pragma once
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// How a foreign program ended.
struct ProcessResult {
  int status = 0; ///< exit status, or 128 + the signal that ended it
  std::string output, errors;
};

/// Runs a program found on PATH without a shell, feeds it the input and waits for its end.
/// Throws EnvironmentError if it cannot be started.
ProcessResult run_process(std::vector<std::string> const& command, std::string const& input = "");

} // namespace mesobridge::workflows
