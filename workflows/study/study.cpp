#include "workflows/study/study.hpp"
#include "cg/distribution_error.hpp"
#include "md/error.hpp"
#include "workflows/job_pool.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/study/trial_file.hpp"
#include "workflows/study/tries.hpp"
#include <algorithm>
#include <map>
#include <mutex>

namespace mesobridge::workflows {
namespace {

/// What trials with a common start share.
std::string start_key(Scene scene) {
  scene.title.clear();
  scene.scheme = {};
  scene.run = {.seed = scene.run.seed};
  return resolved_toml(scene);
}

double start_dt(Scene const& scene, StudyOptions const& options) {
  return options.start_dt / tries_of(scene).shorter_start;
}

/// The common starts, each made once by the first job that needs it.
class Starts {
 public:
  Starts(std::vector<PlannedTrial> const& plan, StudyOptions const& options) : options_(options) {
    for (auto const& trial : plan)
      starts_.try_emplace(start_key(trial.scene));
  }
  sdpd::Checkpoint const& of(Scene const& scene, std::function<bool()> const& keep_going) {
    auto& start = starts_.at(start_key(scene));
    std::lock_guard const lock(start.mutex);
    if (!start.checkpoint)
      start.checkpoint = sdpd::equilibrated_start(settings_of(scene, 1), start_dt(scene, options_),
                                                  options_.start_time, keep_going);
    return *start.checkpoint;
  }

 private:
  struct Start {
    std::mutex mutex;
    std::optional<sdpd::Checkpoint> checkpoint;
  };
  StudyOptions const& options_;
  std::map<std::string, Start> starts_;
};

/// A trial from its common start. That a start cannot be made is a result too.
sdpd::TrialResult begin_and_run(Starts& starts, PlannedTrial const& planned,
                                std::function<bool(std::uint64_t)> const& keep_going) {
  auto const& [name, scene, bins] = planned;
  try {
    auto const& start = starts.of(scene, [&] { return keep_going(0); });
    return sdpd::run_trial(
        engine_trial(scene, bins.value_or(cg::bins_around(start.particles.eps, settings_of(scene, 1).K()))),
        start, keep_going);
  } catch (PhysicsError const& error) {
    return {.failure = fmt::format("no equilibrium to begin with: {}", error.what()),
            .dt = scene.scheme.dt.value};
  }
}

double work_of(Scene const& scene) {
  return static_cast<double>(scene.particles.N) *
         static_cast<double>(scene.run.equilibrate + scene.run.steps);
}

} // namespace

sdpd::Trial engine_trial(Scene const& scene, cg::Bins const& bins) {
  return {.settings = settings_of(scene, 1),
          .settle = scene.run.equilibrate,
          .steps = scene.run.steps,
          .sample_every = scene.run.sample_every,
          .bins = bins};
}

double steps_of_start(Scene const& scene, StudyOptions const& options) {
  return std::ceil(options.start_time / start_dt(scene, options));
}

std::vector<sdpd::TrialResult> run_study(std::vector<PlannedTrial> const& plan, StudyOptions const& options) {
  std::vector<sdpd::TrialResult> results(plan.size());
  Starts starts(plan, options);
  double total = 0, done = 0;
  for (auto const& trial : plan)
    total += work_of(trial.scene);
  std::mutex mutex;
  std::vector<std::function<void()>> jobs;
  for (std::size_t k = 0; k < plan.size(); ++k)
    jobs.push_back([&, k] {
      auto const& [name, scene, bins] = plan[k];
      auto tell = [&](double share) {
        std::lock_guard const lock(mutex);
        return options.keep_going((done + share * work_of(scene)) / total, name);
      };
      auto const file = options.directory / (name + ".json");
      std::string const made_of = identity(scene, bins.value_or(cg::Bins{})) +
                                  fmt::format(" start {} {}", options.start_dt, options.start_time);
      auto stored = options.directory.empty() ? std::nullopt : read_trial(file, made_of);
      if (!stored) {
        double const steps = static_cast<double>(scene.run.equilibrate + scene.run.steps);
        stored = begin_and_run(starts, plan[k],
                               [&](std::uint64_t at) { return tell(static_cast<double>(at) / steps); });
        if (!options.directory.empty())
          write_trial(file, made_of, *stored);
      }
      results[k] = std::move(*stored);
      std::lock_guard const lock(mutex);
      done += work_of(scene);
    });
  run_jobs(jobs, options.threads);
  return results;
}

namespace {

/// Edge of the smallest box, in mean distances between particles: twice the range, and the skin of the lists
/// on both sides.
double narrowest_edge(Scene const& scene) {
  auto const settings = settings_of(scene, 1);
  constexpr double widest_skins = 1.5; // in distances between particles
  return std::max((2 * settings.range() + 1) / settings.spacing(),
                  2 * settings.range() / settings.spacing() + widest_skins);
}

} // namespace

Scene small_sample(Scene const& scene, std::int64_t particles) {
  Scene sample = scene;
  auto const wanted = static_cast<std::int64_t>(std::llround(std::cbrt(particles)));
  sample.box = {}, sample.regions.clear(); // one periodic fluid
  sample.particles.N = wanted * wanted * wanted;
  auto const side = std::max(wanted, static_cast<std::int64_t>(std::ceil(narrowest_edge(sample))));
  sample.particles.N = side * side * side;
  sample.run.trajectory_every = sample.run.vtkhdf_every = sample.run.xyz_every = 0;
  sample.run.instant_every = 0;
  sample.run.checkpoint_every = 0, sample.run.checkpoint_minutes = 0;
  sample.profile = {}, sample.histogram = {};
  sample.output = {};
  return sample;
}

void set_times(Scene& scene, double dt, double settle, double time) {
  auto steps = [dt](double t) { return static_cast<std::int64_t>(std::ceil(t / dt)); };
  constexpr double between_samples = 0.4;
  scene.scheme.dt = {.value = dt, .reduced = true};
  scene.run.equilibrate = steps(settle);
  scene.run.steps = std::max<std::int64_t>(steps(time), 128);
  scene.run.sample_every = std::max<std::int64_t>(
      1, std::min<std::int64_t>(std::llround(between_samples / dt), scene.run.steps / 64));
}

} // namespace mesobridge::workflows
