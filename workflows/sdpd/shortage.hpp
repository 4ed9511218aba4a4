#pragma once
#include "workflows/sdpd/cost_estimate.hpp"
#include "workflows/sdpd/disk_estimate.hpp"
#include <filesystem>

namespace mesobridge::workflows {

/// What this machine lacks for a run into that folder, in a sentence each: memory, room on the disk. What
/// lies in the folder already counts as room, for a run that goes on there.
std::vector<std::string> shortages(CostEstimate const& cost, DiskEstimate const& disk,
                                   std::filesystem::path const& folder);

/// The folder of a run's results: -o, the scene's, or out/ and the file's name.
std::filesystem::path results_folder(std::optional<std::filesystem::path> const& output, Scene const& scene,
                                     std::filesystem::path const& file);

/// Throws EnvironmentError when the run of a scene does not fit this machine.
void refuse_shortages(Scene const& scene, int threads, std::filesystem::path const& folder, Engine engine);

} // namespace mesobridge::workflows
