#pragma once
#include "workflows/coarse/molecule_forces.hpp"
#include "workflows/coarse/potential_beside.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// What `cg potential --method force-matching` tells.
struct ForceMatch {
  ForcesOfFile const& data; ///< its forces may be gone
  cg::MatchedForce const& found;
  PotentialTrial const& trial; ///< of particles with the potential
  std::optional<PotentialBeside> const& beside;
};

Json force_match_json(ForceMatch const& match);
std::string force_match_text(ForceMatch const& match);
/// Force and potential with their errors, beside another potential if there is one; the particles' structure.
Report force_match_report(ForceMatch const& match);

/// What a reader must know first.
std::vector<std::string> force_match_warnings(ForceMatch const& match);

} // namespace mesobridge::workflows
