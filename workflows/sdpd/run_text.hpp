#pragma once
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// The results of a finished run for people, a line each: temperatures, pressure, density and energy drift
/// with their standard errors, beside what the scene sets; then the warnings of its summary.
std::string run_text(RunResult const& result);

} // namespace mesobridge::workflows
