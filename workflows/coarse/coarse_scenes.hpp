#pragma once
#include "workflows/coarse/star_to_dpde.hpp"

namespace mesobridge::workflows {

/// The scene of a run at the temperature that the melt has had, which names the model in one line.
std::string coarse_scene(StarToDpdePlan const& plan, CoarseRun const& run, double T);

/// Time in which a fluid that begins on a lattice comes to rest, before what is sampled.
double settling_time(StarToDpdePlan const& plan);

/// That of the coarse fluid before the piston; P is its pressure at rest, from which the run's length is
/// estimated. Needs plan.v_P.
std::string shock_scene(StarToDpdePlan const& plan, double T, double P);

} // namespace mesobridge::workflows
