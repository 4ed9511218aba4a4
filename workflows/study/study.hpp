#pragma once
#include "sdpd/setup/trial.hpp"
#include "workflows/scene/scene.hpp"
#include <filesystem>

namespace mesobridge::workflows {

/// What the engine needs for a trial of a scene, whose `run` says how many steps settle (equilibrate) and how
/// many are sampled; on one thread.
sdpd::Trial engine_trial(Scene const& scene, cg::Bins const& bins);

/// A trial that is planned: its scene without energy bins, which come from the common start of its size.
struct PlannedTrial {
  std::string name; ///< of its file; unique in a study
  Scene scene;
  std::optional<cg::Bins> bins; ///< of eps / k_B T; others than those around the start
};

struct StudyOptions {
  std::filesystem::path directory; ///< of the stored trials; empty: nothing is stored
  int threads = 1;
  double start_dt = 0.05; ///< reduced time step of the common starts; a fifth of it for DPD and DPDE
  double start_time = 60; ///< reduced time in which they come to equilibrium
  /// Told the share of the work that is done (0 ... 1) and the trial's name; false stops the study.
  std::function<bool(double, std::string const&)> keep_going = [](double, std::string const&) {
    return true;
  };
};

/// Steps that a common start of the scene's fluid makes.
double steps_of_start(Scene const& scene, StudyOptions const& options = {});

/// Runs all trials, several at a time, each on one thread; scenes of one size of particles begin in the same
/// state. Finished trials are stored in the directory and read back instead of being run again. The results
/// do not depend on the threads, but for the times. In the order of the plan. Throws Interrupted.
std::vector<sdpd::TrialResult> run_study(std::vector<PlannedTrial> const& plan, StudyOptions const& options);

/// The scene cut down to what a study needs: a small box of its fluid (at least `particles`, a cube).
Scene small_sample(Scene const& scene, std::int64_t particles);

/// Sets the reduced time step, and steps such that `settle` and `time` (reduced) pass, sampled about every
/// 0.4 units.
void set_times(Scene& scene, double dt, double settle, double time);

} // namespace mesobridge::workflows
