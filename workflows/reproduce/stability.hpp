#pragma once
#include "workflows/reproduce/list.hpp"
#include "workflows/study/study.hpp"

namespace mesobridge::workflows {

/// One run of the stability table.
struct StabilityCase {
  std::string group, name;
  Scene scene;          ///< with its time step
  std::string expected; ///< "runs" or "fails" where the thesis or an independent code says so
};

/// Schemes at the time steps that the thesis names, and fluids in extreme states.
std::vector<StabilityCase> stability_cases();

/// Runs them over a reduced time; a run that cannot go on is a result.
std::vector<sdpd::TrialResult> run_stability(std::vector<StabilityCase> const& cases, double time,
                                             StudyOptions const& options);

} // namespace mesobridge::workflows
