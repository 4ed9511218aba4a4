#pragma once
#include "workflows/study/trial.hpp"

namespace mesobridge::workflows {

/// What a stored trial must have been made of to stand for this one: scene, bins and the program's commit.
std::string identity(Trial const& trial);

/// Writes a finished trial. Throws EnvironmentError.
void write_trial(std::filesystem::path const& file, std::string const& identity, TrialResult const& result);

/// The stored result; nothing if there is none, if the file is damaged, or if it belongs to another trial.
std::optional<TrialResult> read_trial(std::filesystem::path const& file, std::string const& identity);

} // namespace mesobridge::workflows
