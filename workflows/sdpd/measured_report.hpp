#pragma once
#include "workflows/report/report.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// The section of a run's report on the measurements that its scene asks for: means beside what equilibrium
/// makes of them, and each in time. Nothing if there are none.
std::optional<Section> measured_section(std::filesystem::path const& run_file, RunResult const& run,
                                        sdpd::SetState const& set);

} // namespace mesobridge::workflows
