#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// The folder of one run: what its files are called, what is there, and what may be done about it.
class RunFolder {
 public:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path const& path() const { return path_; }
  std::filesystem::path scene() const { return path_ / "scene.toml"; } ///< resolved
  std::filesystem::path run_file() const { return path_ / "run.h5"; }
  std::filesystem::path checkpoint() const { return path_ / "checkpoint.h5"; }
  std::filesystem::path calibration() const { return path_ / "calibration.json"; }
  std::filesystem::path viscosity_trials() const { return path_ / "viscosity.json"; }
  std::filesystem::path time_step_study() const { return path_ / "dt-auto"; }
  std::filesystem::path summary() const { return path_ / "summary.json"; }
  std::filesystem::path report() const { return path_ / "report.html"; }

  std::filesystem::path log() const { return path_ / "log.txt"; } ///< for people

  /// The last one, or the one before it.
  bool has_checkpoint() const;

  /// All that a run writes and that is there, by name. Parts that serve any run whose scene says the same
  /// (calibration, trials of the viscosity, study of the time step) are no results.
  std::vector<std::filesystem::path> results() const;
  /// Whether a run, finished or not, is among them.
  bool holds_run() const;

  /// The resolved scene of the run that is here, without the line that says what it is.
  std::string read_scene() const;
  void write_scene(std::string const& resolved) const;

  /// Moves all results and parts into a new folder in this one, which is returned. Throws EnvironmentError.
  std::filesystem::path back_up() const;

 private:
  bool scene_is_ours() const;

  std::filesystem::path path_;
};

/// How a run is to begin in a folder where there is something.
struct RunClaim {
  std::filesystem::path scene; ///< the user's file
  bool resume = false, force = false;
};

/// What the claim comes to: whether the run goes on with the one that is there, and what the user is told.
struct ClaimedFolder {
  bool goes_on = false;
  std::string message; ///< empty: nothing
};

/// Makes the folder ready for a run, or refuses before anything there is touched: InputError that says what
/// is there and the ways on. With `force` what was there is moved into a backup.
ClaimedFolder claim(RunFolder const& folder, RunClaim const& how);

} // namespace mesobridge::workflows
