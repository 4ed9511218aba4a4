#pragma once
#include "sdpd/method/settings.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/sdpd/film_series.hpp"
#include "workflows/sdpd/histogram_series.hpp"
#include "workflows/sdpd/measured_series.hpp"
#include "workflows/sdpd/profile_series.hpp"
#include "workflows/sdpd/run_file.hpp"
#include "workflows/sdpd/trajectories.hpp"
#include <optional>

namespace mesobridge::workflows {

/// All that a run writes on its way: samples, instants, series, profiles, histograms, film and frames, each
/// on its own schedule. Steps and times in all of them count from the begin of the sampling.
class RunOutputs {
 public:
  /// Creates the files in the folder or, when the run is resumed, goes on with what it wrote `before`. Throws
  /// InputError, EnvironmentError.
  RunOutputs(Scene const& scene, sdpd::SimulationSettings const& settings, OutputUnits const& units,
             std::filesystem::path const& folder, Provenance const& provenance,
             std::optional<FrameSchedules> const& before);

  /// The run file of a folder that was copied while a run wrote there may be older than its checkpoint, which
  /// is that of `done` sampled steps: throws InputError when samples or instants are missing that were due
  /// until then. (Other series may have begun later or with another schedule.)
  void refuse_gaps(std::int64_t done) const;

  /// From this sampled step to the next that any of them wants, at most `steps`.
  std::int64_t steps_to_next(std::int64_t done, std::int64_t steps) const;

  /// Writes what is due after `done` sampled steps.
  void record(std::int64_t done, sdpd::Observation const& observed, sdpd::Simulation const& simulation);

  /// What was written so far is safe, whatever happens to the program. Throws EnvironmentError.
  void mark() { run_file_.mark(), trajectories_.mark(); }
  void close() { run_file_.close(), trajectories_.close(); }

  RunFile const& run_file() const { return run_file_; }

 private:
  void record_instants(std::int64_t done, sdpd::Simulation const& simulation);

  OutputUnits units_;
  double dt_;
  std::int64_t sample_every_, instants_every_, profile_every_, histogram_every_, series_every_, film_every_;
  RunFile run_file_;
  std::optional<ProfileSeries> profiles_;
  std::optional<HistogramSeries> histograms_;
  std::optional<MeasuredSeries> series_;
  std::optional<FilmSeries> film_;
  Trajectories trajectories_;
};

} // namespace mesobridge::workflows
