#pragma once
#include "workflows/beside/run_numbers.hpp"
#include "workflows/command.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// Two runs or more side by side: their numbers with the differences from the first in standard errors of
/// both, what their scenes say otherwise, their series over time. Runs of different units have no number in
/// common.
Report beside_report(std::vector<RunNumbers> const& runs);

/// The numbers of several runs, key by key: {"runs": [...], "numbers": {"T_kin_K": [{"value", "se",
/// "deviation"}]}}; null where a run has no such number, deviations from the first that has it.
Json beside_runs_json(std::vector<RunNumbers> const& runs);

/// The same as a table for the terminal.
std::string beside_runs_text(std::vector<RunNumbers> const& runs);

} // namespace mesobridge::workflows
