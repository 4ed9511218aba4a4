#include "workflows/sdpd/run_scene.hpp"
#include "sdpd/observe/runaway.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/sdpd/histogram_series.hpp"
#include "workflows/sdpd/profile_series.hpp"
#include "workflows/sdpd/run_file.hpp"
#include "workflows/sdpd/trajectories.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <chrono>
#include <optional>

namespace mesobridge::workflows {
namespace {

/// One scene on its way from the first step to the files.
class Run {
 public:
  Run(Scene const& scene, RunOptions const& options)
      : options_(options), scene_(with_density_constants(scene)),
        settings_(settings_of(scene_, options.threads)), simulation_(settings_),
        units_(simulation_.units(), scene.units), provenance_{options.command, settings_.seed,
                                                              resolved_toml(scene_), inputs(scene)},
        every_instant_(instants_every(scene.run)) {}

  RunResult carry_out() {
    require(scene_.run.steps >= 32 * scene_.run.sample_every, "run.steps", scene_.run.steps,
            fmt::format("must be at least 32 run.sample_every = {}, or no errors can be estimated",
                        32 * scene_.run.sample_every));
    if (options_.resume && !stopped_before_first_checkpoint())
      resume();
    else
      start();
    auto const begin = std::chrono::steady_clock::now();
    std::int64_t const first = done_;
    while (done_ < scene_.run.steps) {
      advance(steps_to_next_event());
      record();
      if (!options_.keep_going(static_cast<std::uint64_t>(scene_.run.equilibrate + done_)))
        stop();
    }
    std::chrono::duration<double, std::micro> const spent = std::chrono::steady_clock::now() - begin;
    double const work =
        static_cast<double>(scene_.run.steps - first) * static_cast<double>(simulation_.size());
    return finish(work > 0 ? spent.count() / work : 0);
  }

 private:
  static std::vector<std::filesystem::path> inputs(Scene const& scene) {
    std::vector<std::filesystem::path> files;
    for (auto const& file : {scene.fluid.eos, scene.potential.file.value_or(""),
                             scene.friction.file.value_or(""), scene.conduction.file.value_or(""),
                             scene.internal_energy.model.value_or("")})
      if (std::filesystem::is_regular_file(file))
        files.emplace_back(file);
    return files;
  }

  std::filesystem::path file(char const* name) const { return options_.directory / name; }

  /// The scene with the constants of its densities: those that it gives, those of the checkpoint, or fresh
  /// ones.
  Scene with_density_constants(Scene scene) {
    if (!wants_calibration(scene))
      return scene;
    auto& particles = scene.particles;
    if (options_.resume && std::filesystem::exists(file("checkpoint.h5"))) {
      auto const stored = parse_scene(read_checkpoint(file("checkpoint.h5")).scene, file("checkpoint.h5"));
      particles.density_scale = stored.particles.density_scale;
      particles.density_self = stored.particles.density_self;
      calibration_ = Json::parse(read_text_file(file("calibration.json")));
      return scene;
    }
    auto const found = calibrate(scene, options_.threads, [this] { return options_.keep_going(0); });
    particles.density_scale = found.constants.scale, particles.density_self = found.constants.self;
    calibration_ = calibration_json(found, OutputUnits(settings_of(scene, 1).units(), scene.units));
    write_summary(file("calibration.json"), calibration_);
    return scene;
  }

  /// This very scene began here and did not come to its first checkpoint: it begins again.
  bool stopped_before_first_checkpoint() const {
    return !std::filesystem::exists(file("checkpoint.h5")) && std::filesystem::exists(file("scene.toml")) &&
           read_text_file(file("scene.toml")) == provenance_.scene;
  }

  void start() {
    std::error_code ignored; // what an earlier run left here is none of this one's
    std::filesystem::remove(file("checkpoint.h5"), ignored);
    write_text_file(file("scene.toml"), provenance_.scene);
    sdpd::equilibrate(simulation_, static_cast<std::uint64_t>(scene_.run.equilibrate),
                      [&] { return options_.keep_going(simulation_.step()); });
    run_file_.emplace(file("run.h5"), units_, observables_of(settings_), provenance_);
    open_series();
    trajectories_.emplace(scene_, options_.directory, provenance_, false);
    record();
  }

  void resume() {
    auto const stored = read_checkpoint(file("checkpoint.h5"));
    if (stored.scene != provenance_.scene)
      throw InputError(fmt::format("'{}' was written by another scene than this one: compare '{}' and take "
                                   "the same scene, or another directory",
                                   file("checkpoint.h5").string(), file("scene.toml").string()));
    simulation_.restore(stored.checkpoint);
    done_ = static_cast<std::int64_t>(stored.checkpoint.step) - scene_.run.equilibrate;
    run_file_.emplace(RunFile::continue_file(file("run.h5"), units_, observables_of(settings_)));
    open_series();
    trajectories_.emplace(scene_, options_.directory, provenance_, true);
  }

  /// What the scene asks for beside the samples.
  void open_series() {
    if (scene_.profile.every > 0)
      profiles_.emplace(run_file_->store(), scene_, units_, 1 / settings_.K);
    if (scene_.histogram.every > 0)
      histograms_.emplace(run_file_->store(), scene_, units_);
  }

  std::int64_t steps_to_next_event() const {
    std::int64_t steps = scene_.run.steps - done_;
    for (std::int64_t const every : {scene_.run.sample_every, every_instant_, scene_.run.checkpoint_every,
                                     scene_.profile.every, scene_.histogram.every})
      if (every > 0)
        steps = std::min(steps, every - done_ % every);
    return trajectories_->steps_to_next(done_, steps);
  }

  void advance(std::int64_t steps) {
    simulation_.advance(static_cast<std::uint64_t>(steps));
    done_ += steps;
  }

  /// Samples, instants, profiles, histograms, frames and checkpoints that are due at this step.
  void record() {
    auto due = [this](std::int64_t every) { return every > 0 && done_ % every == 0; };
    double const time = static_cast<double>(done_) * settings_.dt;
    auto const observed = simulation_.observe();
    if (simulation_.has_noise()) // what flows without noise has no temperature of its motion
      sdpd::refuse_runaway(observed, settings_.dt);
    if (due(scene_.run.sample_every))
      run_file_->append(observed, time);
    bool const instant = due(every_instant_), profile = due(scene_.profile.every),
               histogram = due(scene_.histogram.every);
    if (instant || profile || histogram) {
      auto const now =
          profile && profiles_->shows("P") ? simulation_.snapshot_with_virials() : simulation_.snapshot();
      auto const step = simulation_.step();
      if (instant)
        run_file_->append(now, sdpd::moments(now), step);
      if (profile)
        profiles_->append(now, simulation_.box(), step, time * units_.time);
      if (histogram)
        histograms_->append(now, step, time * units_.time);
    }
    trajectories_->record(done_, simulation_, units_, settings_.dt);
    if (done_ > 0 && due(scene_.run.checkpoint_every))
      checkpoint();
  }

  void checkpoint() {
    run_file_->mark(), trajectories_->mark(); // first, so that no file is ever behind the checkpoint
    write_checkpoint(file("checkpoint.h5"), simulation_.checkpoint(), provenance_);
  }

  [[noreturn]] void stop() {
    checkpoint();
    throw Interrupted(
        fmt::format("stopped after {} of {} steps; all samples so far and a checkpoint are in '{}': go on "
                    "with --resume",
                    done_, scene_.run.steps, options_.directory.string()));
  }

  RunResult finish(double us_per_particle_step) {
    // The results are those of the file, so that a resumed run ends with the same bits as an unbroken one.
    auto const sampler = run_file_->replay();
    RunResult result{.scene = scene_,
                     .settings = settings_,
                     .equilibrium = sampler.result(),
                     .neighbours = simulation_.neighbours(),
                     .us_per_particle_step = us_per_particle_step,
                     .times = {sampler.times().begin(), sampler.times().end()},
                     .energies = {sampler.energies().begin(), sampler.energies().end()},
                     .eps = run_file_->particle_values("eps"),
                     .rho = run_file_->particle_values("rho"),
                     .P = run_file_->particle_values("P"),
                     .summary = {}};
    result.summary = summary(result);
    write_summary(file("summary.json"), result.summary);
    run_file_->close();
    trajectories_->close();
    return result;
  }

  static void put_rejections(Json& json, std::string const& name, sdpd::PairCounts const& counts) {
    double const proposed = static_cast<double>(std::max<std::uint64_t>(counts.proposed, 1));
    json[name + "_out_of_domain"] = static_cast<double>(counts.out_of_domain) / proposed;
    json[name + "_metropolis"] = static_cast<double>(counts.metropolis) / proposed;
  }

  Json summary(RunResult const& result) const {
    auto const& e = result.equilibrium;
    auto const observables = observables_of(settings_);
    auto in = [](cg::Estimate const& estimate, double unit) {
      return cg::Estimate{estimate.mean * unit, estimate.se * unit, estimate.n_eff};
    };
    Json json;
    json["title"] = scene_.title;
    json["n"] = simulation_.size();
    json["method"] = scene_.method.name;
    if (observables.densities)
      json["K"] = settings_.K;
    json["dt_reduced"] = settings_.dt;
    json["dt" + units_.time_key] = settings_.dt * units_.time;
    json["steps"] = scene_.run.steps;
    json["neighbours"] = result.neighbours;
    json["density_scale"] = settings_.density_correction.scale;
    json["density_self"] = settings_.density_correction.self;
    if (!calibration_.is_null())
      json["density_calibration"] = calibration_;
    put(json, "T_kin" + units_.temperature_key, in(e.T_kin, units_.temperature));
    if (observables.energies)
      put(json, "T_int" + units_.temperature_key, in(e.T_int, units_.temperature));
    put(json, "P" + units_.pressure_key, in(e.P, units_.pressure));
    if (observables.densities) {
      put(json, "rho" + units_.density_key, in(e.rho.mean, units_.density));
      put(json, "rho_variance", in(e.rho.variance, units_.density * units_.density));
      put(json, "P_internal" + units_.pressure_key, in(e.P_i.mean, units_.pressure));
    }
    if (observables.energies) {
      put(json, "e" + units_.specific_energy_key, in(e.eps.mean, units_.specific_energy));
      put(json, "energy_drift_per_reduced_time", cg::Estimate{e.drift.rate, e.drift.se, 8});
      put(json, "energy_drift_per" + (units_.time_key.empty() ? "_time" : units_.time_key),
          cg::Estimate{e.drift.rate / units_.time, e.drift.se / units_.time, 8});
    }
    for (std::string const energy : {"kinetic_energy", "potential_energy"})
      if (auto const mean = run_file_->mean(energy + units_.energy_key); mean && !observables.densities)
        put(json, energy + "_per_particle" + units_.energy_key,
            in(*mean, 1 / static_cast<double>(simulation_.size())));
    put_rejections(json, "rejected", simulation_.pair_counts());
    if (settings_.conducts())
      put_rejections(json, "conduction_rejected", simulation_.conduction_counts());
    auto const p = simulation_.observe().momentum;
    json["momentum" + units_.momentum_key] = norm(p) * units_.momentum;
    return json;
  }

  RunOptions const& options_;
  Json calibration_; ///< null unless the constants of the densities were found by this run
  Scene scene_;
  sdpd::SimulationSettings settings_;
  sdpd::Simulation simulation_;
  OutputUnits units_;
  Provenance provenance_;
  std::int64_t every_instant_;
  std::optional<RunFile> run_file_;
  std::optional<ProfileSeries> profiles_;
  std::optional<HistogramSeries> histograms_;
  std::optional<Trajectories> trajectories_;
  std::int64_t done_ = 0; ///< of the sampled steps
};

} // namespace

RunResult run_scene(Scene const& scene, RunOptions const& options) {
  return Run(scene, options).carry_out();
}

} // namespace mesobridge::workflows
