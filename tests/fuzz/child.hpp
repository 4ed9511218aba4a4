#pragma once
#include "fuzz/trial.hpp"
#include <sys/types.h>

namespace mesobridge::fuzz {

/// Starts a command of the program in a forked copy of this process, in that folder; what it prints goes to
/// stdout.txt and stderr.txt there.
pid_t start_in_child(std::filesystem::path const& folder, std::vector<std::string> const& words);

/// Runs a command of the program in a forked copy of this process, in that folder. One that still works after
/// `seconds` gets SIGTERM; one that then does not end within `patience` more hangs and is killed.
Outcome run_in_child(std::filesystem::path const& folder, std::vector<std::string> const& words,
                     double seconds = 10, double patience = 10);

} // namespace mesobridge::fuzz
