#include "workflows/sdpd/run_scene.hpp"
#include "sdpd/observe/runaway.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/run_log.hpp"
#include "workflows/sdpd/run_outputs.hpp"
#include "workflows/sdpd/run_summary.hpp"
#include "workflows/sdpd/run_text.hpp"
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
      : options_(options), folder_(options.directory), scene_(with_density_constants(scene)),
        settings_(settings_of(scene_, options.threads)), simulation_(settings_),
        units_(simulation_.units(), scene.units), provenance_{options.command, settings_.seed,
                                                              resolved_toml(scene_), inputs(scene)} {}

  RunResult carry_out() {
    try {
      auto result = run();
      log_->end(run_text(result));
      return result;
    } catch (std::exception const& error) {
      if (log_)
        log_->end(error.what());
      throw;
    }
  }

 private:
  RunResult run() {
    if (options_.resume && !folder_.stopped_before_first_checkpoint(provenance_.scene))
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

  static std::vector<std::filesystem::path> inputs(Scene const& scene) {
    std::vector<std::filesystem::path> files;
    for (auto const& file :
         {scene.fluid.eos, scene.potential.file.value_or(""), scene.friction.file.value_or(""),
          scene.conduction.file.value_or(""), scene.internal_energy.model.value_or("")})
      if (std::filesystem::is_regular_file(file))
        files.emplace_back(file);
    return files;
  }

  /// The scene with the constants of its densities: those that it gives, those of the checkpoint, or fresh
  /// ones.
  Scene with_density_constants(Scene scene) {
    if (!wants_calibration(scene))
      return scene;
    auto& particles = scene.particles;
    if (options_.resume && folder_.has_checkpoint()) {
      auto const stored = parse_scene(read_checkpoint(folder_.checkpoint()).scene, folder_.checkpoint());
      particles.density_scale = stored.particles.density_scale;
      particles.density_self = stored.particles.density_self;
      calibration_ = Json::parse(read_text_file(folder_.calibration()));
      return scene;
    }
    auto const found = calibrate(scene, options_.threads, [this] { return options_.keep_going(0); });
    particles.density_scale = found.constants.scale, particles.density_self = found.constants.self;
    calibration_ = calibration_json(found, OutputUnits(settings_of(scene, 1).units(), scene.units));
    write_summary(folder_.calibration(), calibration_);
    return scene;
  }

  void start() {
    std::error_code ignored; // what an earlier run left here is none of this one's
    std::filesystem::remove(folder_.checkpoint(), ignored);
    write_text_file(folder_.scene(), provenance_.scene);
    open_log(false);
    sdpd::equilibrate(simulation_, static_cast<std::uint64_t>(scene_.run.equilibrate),
                      [&] { return options_.keep_going(simulation_.step()); });
    outputs_.emplace(scene_, settings_, units_, folder_.path(), provenance_, false);
    record();
  }

  void resume() {
    auto const stored = read_checkpoint(folder_.checkpoint());
    if (stored.scene != provenance_.scene)
      throw InputError(fmt::format("'{}' was written by another scene than this one: compare '{}' and take "
                                   "the same scene, or another directory",
                                   folder_.checkpoint().string(), folder_.scene().string()));
    open_log(true);
    simulation_.restore(stored.checkpoint);
    done_ = static_cast<std::int64_t>(stored.checkpoint.step) - scene_.run.equilibrate;
    outputs_.emplace(scene_, settings_, units_, folder_.path(), provenance_, true);
  }

  void open_log(bool resume) {
    log_.emplace(folder_.log(), resume, options_.command, scene_, settings_, options_.tell);
  }

  std::int64_t steps_to_next_event() const {
    std::int64_t steps = scene_.run.steps - done_;
    for (std::int64_t const every : {scene_.run.checkpoint_every, log_->every()})
      if (every > 0)
        steps = std::min(steps, every - done_ % every);
    return outputs_->steps_to_next(done_, steps);
  }

  void advance(std::int64_t steps) {
    simulation_.advance(static_cast<std::uint64_t>(steps));
    done_ += steps;
  }

  /// What is due at this step: all outputs, then the checkpoint.
  void record() {
    auto const observed = simulation_.observe();
    if (simulation_.has_noise()) // what flows without noise has no temperature of its motion
      sdpd::refuse_runaway(observed, settings_.dt);
    outputs_->record(done_, observed, simulation_);
    if (done_ % log_->every() == 0)
      log_->thermo(done_, observed);
    if (done_ > 0 && scene_.run.checkpoint_every > 0 && done_ % scene_.run.checkpoint_every == 0)
      checkpoint();
  }

  void checkpoint() {
    outputs_->mark(); // first, so that no file is ever behind the checkpoint
    write_checkpoint(folder_.checkpoint(), simulation_.checkpoint(), provenance_);
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
    auto const& file = outputs_->run_file();
    auto const sampler = file.replay();
    RunResult result{.scene = scene_,
                     .settings = settings_,
                     .equilibrium = sampler.result(),
                     .neighbours = simulation_.neighbours(),
                     .us_per_particle_step = us_per_particle_step,
                     .times = {sampler.times().begin(), sampler.times().end()},
                     .energies = {sampler.energies().begin(), sampler.energies().end()},
                     .eps = file.particle_values("eps"),
                     .rho = file.particle_values("rho"),
                     .P = file.particle_values("P"),
                     .findings = {},
                     .summary = {}};
    result.findings = findings_of(sampler, result, simulation_);
    result.summary = run_summary(result, simulation_, file, units_, calibration_);
    write_summary(folder_.summary(), result.summary);
    outputs_->close();
    return result;
  }

  RunOptions const& options_;
  RunFolder folder_;
  Json calibration_; ///< null unless the constants of the densities were found by this run
  Scene scene_;
  sdpd::SimulationSettings settings_;
  sdpd::Simulation simulation_;
  OutputUnits units_;
  Provenance provenance_;
  std::optional<RunOutputs> outputs_;
  std::optional<RunLog> log_;
  std::int64_t done_ = 0; ///< of the sampled steps
};

} // namespace

RunResult run_scene(Scene const& scene, RunOptions const& options) {
  check_run(scene, options.threads);
  return Run(scene, options).carry_out();
}

} // namespace mesobridge::workflows
