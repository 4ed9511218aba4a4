#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/sdpd/equilibrium_report.hpp"
#include "workflows/sdpd/film.hpp"
#include "workflows/sdpd/lammps_run.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/sdpd/run_text.hpp"
#include "workflows/sdpd/shortage.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/study/automatic_dt.hpp"
#include "workflows/time_limit.hpp"
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

struct RunCommandOptions {
  std::string scene, engine = "built-in";
  std::vector<std::string> set;
  bool resume = false, force = false, no_report = false, frames = false, verbose = false;
  std::optional<double> max_hours;
};

int threads_of(Context const& context) {
  return context.options.threads.value_or(available_threads());
}

/// The scene with the time step that a short study finds.
Scene with_time_step(Scene const& scene, RunFolder const& folder, Context const& context,
                     TimeLimit const& limit) {
  std::error_code ignored;
  std::filesystem::create_directories(folder.time_step_study(), ignored); // writing there says what is wrong
  auto progress = context.progress("Finding the time step", 1);
  auto const [chosen, why] =
      choose_time_step(scene, {.directory = folder.time_step_study(),
                               .threads = threads_of(context),
                               .keep_going = [&](double share, std::string const& name) {
                                 progress.update(share, name);
                                 return !interrupt_requested() && !limit.is_over();
                               }});
  progress.finish();
  context.log->info(why);
  return chosen;
}

/// Who watches the progress on a terminal sees the lines of thermodynamics when he asks for them.
std::function<void(std::string const&)> thermo_printer(RunCommandOptions const& options,
                                                       Context const& context) {
  bool const bar = Progress::style_of_stderr() == Progress::Style::bar;
  if (!options.verbose && (bar || context.options.quiet || context.reports))
    return {};
  std::string const above_the_bar = bar ? "\r\033[K" : "";
  return [&log = *context.log, above_the_bar](std::string const& line) { log.warn(above_the_bar + line); };
}

/// The run that is there, whose scene this one must be; nothing if it has not come to a checkpoint.
std::optional<PastRun> past_of(RunFolder const& folder, Scene& scene, Context const& context) {
  if (!folder.has_checkpoint()) {
    if (std::filesystem::exists(folder.summary()))
      throw InputError(fmt::format("'{}' holds a finished run without a checkpoint, so that it cannot be "
                                   "extended: begin anew with --force or in another folder",
                                   folder.path().string()));
    if (std::filesystem::exists(folder.scene()))
      resumed_scene(scene, folder.read_scene(), {}, folder.scene());
    context.log->info("the run in '{}' was stopped before its first checkpoint: it begins again",
                      folder.path().string());
    return std::nullopt;
  }
  auto stored = read_checkpoint(folder.checkpoint());
  if (!stored.warning.empty())
    context.log->warn("warning: {}", stored.warning);
  scene = resumed_scene(scene, stored.scene, stored.inputs, folder.checkpoint());
  return past_run(std::move(stored));
}

RunResult run_in(RunFolder const& folder, Scene scene, RunCommandOptions const& options,
                 Context const& context, TimeLimit const& limit, std::optional<OtherEngine> const& engine) {
  auto const claimed = claim(folder, {options.scene, options.resume, options.force});
  if (!claimed.message.empty())
    context.log->info(claimed.message);
  auto past = claimed.goes_on ? past_of(folder, scene, context) : std::nullopt;
  if (scene.scheme.dt.automatic) {
    scene = with_time_step(scene, folder, context, limit);
    for (auto const& doubt :
         doubts_about(scene, settings_of(scene, 1))) // what a given dt has shown in `check`
      if (doubt.name == "reflection")
        context.log->warn("warning: {}", doubt.text);
  }
  auto progress = context.progress(scene.title, static_cast<double>(scene.run.equilibrate + scene.run.steps));
  auto done = run_scene(scene, {.directory = folder.path(),
                                .threads = threads_of(context),
                                .past = std::move(past),
                                .command = context.command_line(),
                                .tell = thermo_printer(options, context),
                                .keep_going =
                                    [&](std::uint64_t steps) {
                                      progress.update(static_cast<double>(steps));
                                      return !interrupt_requested() && !limit.is_over();
                                    },
                                .engine = engine});
  progress.finish();
  return done;
}

/// Warns of what was found in the samples. Throws PhysicsError when the state is not the scene's.
void tell_findings(RunResult const& done, std::filesystem::path const& folder, Context const& context) {
  for (auto const& finding : done.findings)
    if (!finding.spoils)
      context.log->warn("warning: {}", finding.text);
  if (auto const failure = failure_of(done.findings); !failure.empty())
    throw PhysicsError(
        fmt::format("the files of the run are written into '{}', but {}", folder.string(), failure));
}

Result result_of(RunResult const& done, std::filesystem::path const& to_look_at, bool no_report) {
  Result result;
  result.json = done.summary;
  result.json["us_per_particle_step"] = done.us_per_particle_step;
  if (!no_report)
    result.json["report"] = to_look_at.string();
  result.text = run_text(done) + to_look_at.string();
  return result;
}

/// The run in its folder, with report and findings.
Result carry_out(RunCommandOptions const& options, Context const& context, Scene const& scene,
                 std::filesystem::path const& directory, TimeLimit const& limit,
                 std::optional<OtherEngine> const& engine) {
  RunFolder const folder(context.output_directory(directory));
  FolderLock const lock(folder.path(), context.command_line());
  try {
    auto const done = run_in(folder, scene, options, context, limit, engine);
    if (!options.no_report)
      write_equilibrium_report(folder.report(), done, context.command_line());
    if (options.frames)
      write_film_frames(folder.path(), done.scene, done.settings);
    tell_findings(done, folder.path(), context);
    return result_of(done, options.no_report ? folder.summary() : folder.report(), options.no_report);
  } catch (Interrupted const& stop) {
    std::string what = stop.what();
    if (what.find("--resume") == std::string::npos) // before the first checkpoint
      what += ": begin again, or go on with what is stored, with --resume";
    if (!interrupt_requested() && limit.is_over())
      what = fmt::format("the time of --max-hours {} is over: {}", *options.max_hours, what);
    throw Interrupted(what);
  }
}

Result run_scene_file(RunCommandOptions const& options, Context const& context) {
  TimeLimit const limit(options.max_hours);
  auto overrides = options.set;
  if (context.options.seed)
    overrides.push_back(fmt::format("run.seed={}", *context.options.seed));
  int const threads = threads_of(context);
  Engine const engine = engine_named(options.engine);
  Scene const scene = load_run(options.scene, overrides, threads, engine);
  require(!options.frames || scene.film.quantity, "--frames", "given",
          "needs a film: give film.quantity, whose value colours the particles");
  auto const directory = results_folder(context.options.output, scene, options.scene);
  refuse_shortages(scene, threads, directory, engine);
  if (engine == Engine::built_in)
    return carry_out(options, context, scene, directory, limit, std::nullopt);
  return run_on_lammps(scene, directory, context, [&](OtherEngine const& other) {
    return carry_out(options, context, scene, directory, limit, other);
  });
}

void declare(CLI::App& app, RunCommandOptions& options) {
  add_scene(app, options.scene, options.set);
  add_engine(app, options.engine);
  auto* resume = app.add_flag(
      "--resume", options.resume,
      "Go on from the checkpoint in the output directory, or begin if nothing is there yet; with "
      "--set run.steps=... also of a finished run, which is extended. May change run.steps, title, "
      "and the schedules of trajectories, profiles, histograms and checkpoints");
  app.add_flag("--force", options.force,
               "Begin anew where results are: they are moved into backup-1, backup-2 ... there")
      ->excludes(resume);
  app.add_option("--max-hours", options.max_hours,
                 "Stop with a checkpoint and exit code 130 before so much time has passed, as batch "
                 "queues want; go on with --resume")
      ->type_name("HOURS")
      ->check(CLI::Range(1e-6, 1e6).description(""));
  app.add_flag("--no-report", options.no_report, "Write no report.html");
  app.add_flag("--frames", options.frames,
               "Write the frames of the scene's film as pictures too, frames/frame-0001.png ...");
  app.add_flag("--verbose", options.verbose,
               "Show the lines of thermodynamics that log.txt gets, also on a terminal");
}

} // namespace

extern Declaration const run_command = with_options<RunCommandOptions, declare, run_scene_file>;

} // namespace mesobridge::workflows
