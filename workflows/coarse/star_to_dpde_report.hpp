#pragma once
#include "workflows/coarse/kept.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// What the coarse fluid keeps of the molecular one, each number with its standard error, and what it costs.
Json star_to_dpde_summary(StarToDpdePlan const& plan, Kept const& kept);

/// The report but for its provenance.
Report star_to_dpde_report(StarToDpdePlan const& plan, std::filesystem::path const& directory,
                           Kept const& kept);

} // namespace mesobridge::workflows
