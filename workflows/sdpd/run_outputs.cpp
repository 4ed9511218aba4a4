#include "workflows/sdpd/run_outputs.hpp"
#include "workflows/sdpd/run_folder.hpp"

namespace mesobridge::workflows {
namespace {

RunFile open_run_file(std::filesystem::path const& file, OutputUnits const& units, sdpd::Features features,
                      Provenance const& provenance, bool resume) {
  return resume ? RunFile::continue_file(file, units, features) : RunFile(file, units, features, provenance);
}

bool is_due(std::int64_t done, std::int64_t every) {
  return every > 0 && done % every == 0;
}

} // namespace

RunOutputs::RunOutputs(Scene const& scene, sdpd::SimulationSettings const& settings, OutputUnits const& units,
                       std::filesystem::path const& folder, Provenance const& provenance,
                       std::optional<FrameSchedules> const& before)
    : units_(units), dt_(settings.dt), sample_every_(scene.run.sample_every),
      instants_every_(instants_every(scene.run)), profile_every_(scene.profile.every),
      histogram_every_(scene.histogram.every), series_every_(scene.series.every),
      film_every_(film_every(scene)),
      run_file_(open_run_file(RunFolder(folder).run_file(), units, settings.features(), provenance,
                              before.has_value())),
      profiles_(profile_every_ > 0 ? std::optional<ProfileSeries>(std::in_place, run_file_.store(), scene,
                                                                  units, 1 / settings.K())
                                   : std::nullopt),
      histograms_(histogram_every_ > 0
                      ? std::optional<HistogramSeries>(std::in_place, run_file_.store(), scene, units)
                      : std::nullopt),
      series_(series_every_ > 0
                  ? std::optional<MeasuredSeries>(std::in_place, run_file_.store(), scene, units)
                  : std::nullopt),
      film_(film_every_ > 0
                ? std::optional<FilmSeries>(std::in_place, run_file_.store(), scene, settings, units)
                : std::nullopt),
      trajectories_(scene, folder, provenance, before) {}

void RunOutputs::refuse_gaps(std::int64_t done) const {
  auto const last = [&](std::int64_t every) { return done - done % every; };
  run_file_.refuse_gap(last(sample_every_), last(instants_every_));
}

std::int64_t RunOutputs::steps_to_next(std::int64_t done, std::int64_t steps) const {
  for (std::int64_t const every :
       {sample_every_, instants_every_, profile_every_, histogram_every_, series_every_, film_every_})
    if (every > 0)
      steps = std::min(steps, every - done % every);
  return trajectories_.steps_to_next(done, steps);
}

void RunOutputs::record(std::int64_t done, sdpd::Observation const& observed,
                        sdpd::Simulation const& simulation) {
  auto const time = static_cast<double>(done) * dt_;
  if (is_due(done, sample_every_))
    run_file_.append(observed, done, time);
  if (is_due(done, series_every_))
    series_->append(simulation, done, time * units_.time);
  record_instants(done, simulation);
  trajectories_.record(done, simulation, units_, dt_);
}

void RunOutputs::record_instants(std::int64_t done, sdpd::Simulation const& simulation) {
  bool const instant = is_due(done, instants_every_), profile = is_due(done, profile_every_),
             histogram = is_due(done, histogram_every_), film = is_due(done, film_every_);
  if (!instant && !profile && !histogram && !film)
    return;
  double const time = static_cast<double>(done) * dt_ * units_.time;
  auto const now =
      profile && profiles_->shows("P") ? simulation.snapshot_with_virials() : simulation.snapshot();
  if (instant) {
    auto moments = sdpd::moments(now);
    moments.pairing = simulation.pairing_fraction();
    moments.crystal = simulation.crystal_fraction();
    run_file_.append(now, moments, done);
  }
  if (profile)
    profiles_->append(now, simulation.box(), done, time);
  if (histogram)
    histograms_->append(now, done, time);
  if (film)
    film_->append(now, done, time);
}

} // namespace mesobridge::workflows
