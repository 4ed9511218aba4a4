#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/observe/health.hpp"
#include "workflows/command.hpp"
#include "workflows/sdpd/other_engine.hpp"
#include "workflows/sdpd/resumption.hpp"
#include "workflows/sdpd/settings.hpp"

namespace mesobridge::workflows {

struct RunOptions {
  std::filesystem::path directory; ///< exists
  int threads = 1;
  /// To go on from; the scene is then that of resumed_scene(). Nothing: the run begins, and what another one
  /// left in the directory is replaced.
  std::optional<PastRun> past = {};
  bool told_again = false; ///< of a finished run, whose log and summary stay as they are
  std::string command;     ///< the command line, for the files' provenance
  std::function<void(std::string const&)> tell = {}; ///< gets the log's lines of thermodynamics, if given
  /// Told the steps done, now and then; false stops the run (a checkpoint is written, Interrupted is thrown).
  std::function<bool(std::uint64_t)> keep_going = [](std::uint64_t) { return true; };
  /// Of the sampled steps, if not the built-in one; equilibrium is always found by that.
  std::optional<OtherEngine> engine = {};
};

/// A finished run.
struct RunResult {
  Scene scene;
  sdpd::SimulationSettings settings;
  sdpd::Equilibrium equilibrium; ///< reduced
  /// In the errors of its temperatures: what the time step has added to the energy (sdpd/README.md, Eq.
  /// (S90)).
  double gained_temperature = 0;
  double neighbours = 0;
  double us_per_particle_step = 0;     ///< of the sampled part, with its observations and files
  std::vector<double> times, energies; ///< reduced
  std::vector<double> eps, rho, P;     ///< of single particles at the sampled instants, in the scene's units
  std::vector<sdpd::Finding> findings; ///< what its samples say against the run
  Json summary;                        ///< what stands in summary.json
};

/// Runs a scene: equilibrates, samples, writes scene.toml, run.h5, trajectories (if asked for), checkpoints,
/// summary.json and log.txt into the directory; the bits of results do not depend on when checkpoints are
/// written, nor on how often the run was stopped and resumed. Throws PhysicsError when the run cannot go on;
/// Interrupted when it was stopped, with a message that says where and how to go on.
RunResult run_scene(Scene const& scene, RunOptions const& options);

} // namespace mesobridge::workflows
