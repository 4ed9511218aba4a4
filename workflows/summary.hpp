#pragma once
#include "cg/estimate.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Writes an uncertain quantity and its twin: {"P_Pa": 6.8e8, "P_Pa_se": 1e6}.
void put(Json& object, std::string const& key, cg::Estimate const& estimate);

/// The text of a JSON value. Throws PhysicsError that names the key if a number in it is not finite.
std::string checked_dump(Json const& value);

/// Writes a JSON file (through a temporary file, renamed at the end). Throws PhysicsError, EnvironmentError.
void write_summary(std::filesystem::path const& file, Json const& value);

/// Writes summary.json and report.html into the folder. The result is the summary and the path of the report.
Result with_report(std::filesystem::path const& folder, Json summary, std::string const& html);

} // namespace mesobridge::workflows
