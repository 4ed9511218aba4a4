#pragma once
#include "workflows/study/study.hpp"

namespace mesobridge::workflows {

/// A scene with dt = "auto" and the time step that a short trade-off of its own scheme finds for its
/// tolerances of the fluid at rest, and trials of its beginning for that of the energy balance; what it was
/// chosen for stays as `scheme.dt_chosen_for`. The same for any number of threads. Trials are stored in
/// `options.directory`. Throws PhysicsError when no time step keeps the tolerances.
struct ChosenTimeStep {
  Scene scene;
  std::string why; ///< "dt = 0.12 reduced: limited by the wanted energy drift"
};
ChosenTimeStep choose_time_step(Scene const& scene, StudyOptions const& options);

/// The largest time step that the study may choose, reduced.
double largest_tried_dt(Scene const& scene);

/// The runs of that study with the fluid at rest; none where the tolerance is of the balance alone.
std::vector<PlannedTrial> time_step_trials(Scene const& scene);

/// The scene with the time step that the stored scene was given for the same tolerances. Throws InputError
/// when the stored scene had others.
Scene with_stored_time_step(Scene const& scene, Scene const& stored);

} // namespace mesobridge::workflows
