#include "workflows/sdpd/run_scene.hpp"
#include "sdpd/observe/runaway.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "workflows/sdpd/energy_of_scene.hpp"
#include "workflows/sdpd/kept_tolerances.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/run_log.hpp"
#include "workflows/sdpd/run_outputs.hpp"
#include "workflows/sdpd/run_summary.hpp"
#include "workflows/sdpd/run_text.hpp"
#include "workflows/sdpd/scene_findings.hpp"
#include "workflows/sdpd/scene_inputs.hpp"
#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <chrono>
#include <optional>

namespace mesobridge::workflows {
namespace {

/// Between two questions whether to go on; about a tenth of a second's work of a slow processor.
constexpr std::int64_t particle_steps_between_questions = 100'000;

/// One scene on its way from the first step to the files.
class Run {
 public:
  Run(Scene const& scene, RunOptions const& options)
      : options_(options), folder_(options.directory),
        fluid_(with_findings_about_fluid(scene, folder_, options)), scene_(fluid_.scene),
        settings_(settings_of(scene_, options.threads)), simulation_(settings_),
        units_(simulation_.units(), scene.units), provenance_{options.command, settings_.seed,
                                                              resolved_toml(scene_), scene_inputs(scene)} {}

  RunResult carry_out() {
    try {
      auto result = run();
      if (log_)
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
    if (options_.engine)
      options_.engine->settle(settings_);
    if (options_.past)
      go_on(*options_.past);
    else
      begin();
    auto const begin = std::chrono::steady_clock::now();
    std::int64_t const first = done_;
    while (done_ < scene_.run.steps) {
      advance(steps_to_next_event());
      record();
      if (done_ < scene_.run.steps)
        ask();
    }
    std::chrono::duration<double, std::micro> const spent = std::chrono::steady_clock::now() - begin;
    made_steps_ = done_ > first;
    double const work =
        static_cast<double>(scene_.run.steps - first) * static_cast<double>(simulation_.size());
    if (made_steps_)
      checkpoint(); // a finished run may be extended
    return finish(work > 0 ? spent.count() / work : 0);
  }

  void begin() {
    remove_checkpoints(folder_.checkpoint()); // what an earlier run left here is none of this one's
    folder_.write_scene(provenance_.scene);
    open_log(false);
    try {
      equilibrate();
    } catch (PhysicsError const&) {
      std::error_code ignored;
      if (!folder_.has_checkpoint() && !std::filesystem::exists(folder_.run_file()))
        std::filesystem::remove(folder_.scene(), ignored); // another try is not in its way
      throw;
    }
    begin_to_sample();
  }

  void go_on(PastRun const& past) {
    if (!options_.told_again)
      open_log(true);
    auto const& checkpoint_there = past.stored.checkpoint;
    simulation_.restore(checkpoint_there);
    done_ = static_cast<std::int64_t>(checkpoint_there.step) - scene_.run.equilibrate;
    require(done_ <= scene_.run.steps, "run.steps", scene_.run.steps,
            fmt::format("must be at least {}: so many are done already", done_));
    bool const changed = !options_.told_again && past.stored.scene != provenance_.scene;
    if (changed && folder_.read_scene() == past.stored.scene) // not a file that its user has changed
      folder_.write_scene(provenance_.scene);
    if (done_ < 0) {
      equilibration_ = past.stored.equilibration;
      done_ = 0;
      equilibrate();
      begin_to_sample();
      return;
    }
    outputs_.emplace(scene_, settings_, units_, folder_.path(), provenance_, past.frames);
    outputs_->refuse_gaps(done_);
    if (changed)
      checkpoint(); // with the new schedules
  }

  void equilibrate() {
    std::uint64_t const steps_between_questions =
        std::clamp<std::uint64_t>(particle_steps_between_questions / simulation_.size(), 1, 32);
    sdpd::Equilibration equilibration(simulation_, static_cast<std::uint64_t>(scene_.run.equilibrate),
                                      equilibration_);
    while (!equilibration.is_done()) {
      equilibration.advance();
      equilibration_ = equilibration.progress();
      if (equilibration.is_done())
        break;
      if (is_time_for_checkpoint(static_cast<std::int64_t>(equilibration_.done)))
        checkpoint();
      if (equilibration_.done % steps_between_questions == 0)
        ask();
    }
    equilibration_ = {};
  }

  void begin_to_sample() {
    outputs_.emplace(scene_, settings_, units_, folder_.path(), provenance_, std::nullopt);
    record();
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
    for (auto const end = done_ + steps; done_ < end;) {
      done_ += slices_.advance(simulation_, end - done_);
      if (done_ < end)
        ask();
    }
  }

  /// What is due at this step: all outputs, then the checkpoint.
  void record() {
    auto const observed = simulation_.observe();
    sdpd::refuse_not_finite(observed, settings_.dt);
    if (simulation_.has_noise() && !is_driven(scene_)) // what flows has no one temperature of its motion
      sdpd::refuse_runaway(observed, settings_.dt);
    outputs_->record(done_, observed, simulation_);
    if (done_ % log_->every() == 0)
      log_->thermo(done_, observed);
    if (done_ > 0 && is_time_for_checkpoint(done_))
      checkpoint();
  }

  bool is_time_for_checkpoint(std::int64_t steps) const {
    std::chrono::duration<double, std::ratio<60>> const minutes =
        std::chrono::steady_clock::now() - last_checkpoint_;
    auto const& run = scene_.run;
    return (run.checkpoint_every > 0 && steps % run.checkpoint_every == 0) ||
           (run.checkpoint_minutes > 0 && minutes.count() >= run.checkpoint_minutes);
  }

  void checkpoint() {
    if (outputs_)
      outputs_->mark(); // first, so that no file is ever behind the checkpoint
    write_checkpoint(folder_.checkpoint(), simulation_.checkpoint(), provenance_, equilibration_);
    last_checkpoint_ = std::chrono::steady_clock::now();
  }

  /// Asks whether to go on, and stops if not.
  void ask() {
    if (options_.keep_going(simulation_.step()))
      return;
    checkpoint();
    auto const where = options_.directory.string();
    if (!outputs_)
      throw Interrupted(
          fmt::format("stopped after {} of {} steps to equilibrium; a checkpoint is in '{}': go on "
                      "with --resume",
                      equilibration_.done, scene_.run.equilibrate, where));
    throw Interrupted(
        fmt::format("stopped after {} of {} steps; all samples so far and a checkpoint are in '{}': go on "
                    "with --resume",
                    done_, scene_.run.steps, where));
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
    auto const set = energy_of_scene(scene_, settings_, simulation_);
    double const set_temperature_error = set ? sdpd::set_temperature_error(sampler, *set) : 0;
    if (set) {
      sdpd::add_error_of_set_energy(result.equilibrium, set_temperature_error, *set);
      result.gained_temperature = sdpd::gained_temperature(sampler, *set);
    }
    result.findings = findings_of(sampler, result, simulation_);
    result.summary = run_summary(result, simulation_, file, units_, fluid_.densities);
    put_viscosities(result.summary, scene_, fluid_.viscosity);
    if (set)
      result.summary["set_temperature" + units_.temperature_key + "_se"] =
          set_temperature_error * units_.temperature;
    if (auto const kept = kept_tolerances(result); !kept.is_null())
      result.summary["tolerances"] = kept;
    tell_engine(result.summary, options_.engine, made_steps_, folder_.summary());
    if (!options_.told_again)
      write_summary(folder_.summary(), result.summary);
    outputs_->close();
    return result;
  }

  RunOptions const& options_;
  RunFolder folder_;
  SceneFindings fluid_;
  Scene const& scene_;
  sdpd::SimulationSettings settings_;
  sdpd::Simulation simulation_;
  OutputUnits units_;
  Provenance provenance_;
  std::optional<RunOutputs> outputs_;
  std::optional<RunLog> log_;
  Slices slices_{std::max<std::int64_t>(1, particle_steps_between_questions /
                                               static_cast<std::int64_t>(simulation_.size())),
                 options_.engine};
  bool made_steps_ = false;                        ///< in this call
  std::int64_t done_ = 0;                          ///< of the sampled steps
  sdpd::EquilibrationProgress equilibration_ = {}; ///< while it is under way
  std::chrono::steady_clock::time_point last_checkpoint_ = std::chrono::steady_clock::now();
};

} // namespace

RunResult run_scene(Scene const& scene, RunOptions const& options) {
  check_run(scene, options.threads);
  return Run(scene, options).carry_out();
}

} // namespace mesobridge::workflows
