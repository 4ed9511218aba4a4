#pragma once
#include "workflows/study/study.hpp"

namespace mesobridge::workflows {

/// A time step for scenes that something drives.
struct BalancedTimeStep {
  double dt = 0;        ///< reduced
  double share = 0;     ///< of lost energy that its trial lets expect at the end of the run
  bool longest = false; ///< it is the first that was tried: no longer ones were
};

/// The largest time step that is tried for a tolerance of the energy balance, reduced: the fastest motion
/// that the scene names crosses half the distance between particles.
double largest_driven_dt(Scene const& scene);

/// The largest time step, not above `largest` and in steps of the search, with which the scene's own run
/// keeps its tolerance (scheme.drift in per cent) as far as trials of its beginning tell: each makes a fifth
/// of the run's steps, or as many as what is fastest takes for 20 spacings. The search begins at `largest`
/// and goes down. The same for any number of threads; trials are stored in `options.directory`. Throws
/// PhysicsError when no time step keeps it, and where the run has no beginning; Interrupted.
BalancedTimeStep find_balanced_time_step(Scene const& scene, double largest, StudyOptions const& options);

/// Particles times steps that the search usually takes; 0 for scenes without that tolerance.
double work_of_balance_trials(Scene const& scene);

} // namespace mesobridge::workflows
