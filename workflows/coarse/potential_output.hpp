#pragma once
#include "workflows/coarse/potential_search.hpp"
#include "workflows/command.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// Columns r and u, as scenes read them (potential.file).
std::string potential_csv(cg::PairPotential const& potential);

/// The structure, all trials with their differences and pressures, and the best one's curves.
Json potential_json(CoarseStructure const& structure, std::vector<PotentialTrial> const& trials);
std::string potential_text(CoarseStructure const& structure, std::vector<PotentialTrial> const& trials);

/// Potentials and structures, the first, the best and the one that was to be reached.
Report potential_report(CoarseStructure const& structure, std::vector<PotentialTrial> const& trials,
                        std::string const& name, std::string const& units);

} // namespace mesobridge::workflows
