#pragma once
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// Writes the report of one run at equilibrium: temperatures, pressure and density beside the equation of
/// state, distributions, energy error. Throws EnvironmentError.
void write_equilibrium_report(std::filesystem::path const& file, RunResult const& run,
                              std::string const& command);

} // namespace mesobridge::workflows
