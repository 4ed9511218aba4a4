#pragma once
#include "sdpd/setup/trial.hpp"
#include "workflows/scene/scene.hpp"
#include <filesystem>

namespace mesobridge::workflows {

/// What a stored trial must have been made of to stand for that of this scene: scene, bins and the program's
/// commit.
std::string identity(Scene const& scene, cg::Bins const& bins);

/// Writes a finished trial. Throws EnvironmentError.
void write_trial(std::filesystem::path const& file, std::string const& identity,
                 sdpd::TrialResult const& result);

/// The stored result; nothing if there is none, if the file is damaged, or if it belongs to another trial.
std::optional<sdpd::TrialResult> read_trial(std::filesystem::path const& file, std::string const& identity);

} // namespace mesobridge::workflows
