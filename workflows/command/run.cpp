#include "workflows/command/list.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/sdpd/equilibrium_report.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/sdpd/run_text.hpp"
#include "workflows/sdpd/shortage.hpp"
#include "workflows/study/automatic_dt.hpp"
#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> set;
  bool resume = false;
  bool verbose = false;
};

/// A scene whose time step is to be found: the one of the run that is resumed, or that of a short study.
Scene with_time_step(Scene const& scene, bool resume, std::filesystem::path const& directory,
                     Context& context) {
  auto const checkpoint = directory / "checkpoint.h5";
  if (resume && std::filesystem::exists(checkpoint))
    return with_stored_time_step(scene, parse_scene(read_checkpoint(checkpoint).scene, checkpoint));
  auto const trials = directory / "dt-auto";
  std::error_code ignored;
  std::filesystem::create_directories(trials, ignored); // writing there says what is wrong
  auto progress = context.progress("Finding the time step", 1);
  auto const [chosen, why] =
      choose_time_step(scene, {.directory = trials,
                               .threads = context.options.threads.value_or(available_threads()),
                               .keep_going = [&](double share, std::string const& name) {
                                 progress.update(share, name);
                                 return !interrupt_requested();
                               }});
  progress.finish();
  context.log->info(why);
  return chosen;
}

/// Who watches the progress on a terminal sees the lines of thermodynamics when he asks for them.
std::function<void(std::string const&)> thermo_printer(Options const& options, Context const& context) {
  bool const bar = Progress::style_of_stderr() == Progress::Style::bar;
  if (!options.verbose && (bar || context.options.quiet || context.reports))
    return {};
  std::string const above_the_bar = bar ? "\r\033[K" : "";
  return [&log = *context.log, above_the_bar](std::string const& line) { log.warn(above_the_bar + line); };
}

Result run(Options const& options, Context& context) {
  auto overrides = options.set;
  if (context.options.seed)
    overrides.push_back(fmt::format("run.seed={}", *context.options.seed));
  int const threads = context.options.threads.value_or(available_threads());
  Scene scene = load_run(options.scene, overrides, threads);
  auto const folder = results_folder(context.options.output, scene, options.scene);
  refuse_shortages(scene, threads, folder);
  auto const directory = context.output_directory(folder);
  if (scene.scheme.dt.automatic)
    scene = with_time_step(scene, options.resume, directory, context);
  auto const total = scene.run.equilibrate + scene.run.steps;
  auto progress = context.progress(scene.title, static_cast<double>(total));
  auto const done = run_scene(scene, {.directory = directory,
                                      .threads = threads,
                                      .resume = options.resume,
                                      .command = context.command_line(),
                                      .tell = thermo_printer(options, context),
                                      .keep_going = [&](std::uint64_t steps) {
                                        progress.update(static_cast<double>(steps));
                                        return !interrupt_requested();
                                      }});
  progress.finish();
  write_equilibrium_report(directory / "report.html", done, context.command_line());
  Result result;
  result.json = done.summary;
  result.json["us_per_particle_step"] = done.us_per_particle_step;
  result.json["report"] = (directory / "report.html").string();
  result.text = run_text(done) + (directory / "report.html").string();
  for (auto const& finding : done.findings)
    if (!finding.spoils)
      context.log->warn("warning: {}", finding.text);
  if (auto const failure = failure_of(done.findings); !failure.empty())
    throw PhysicsError(
        fmt::format("the files of the run are written into '{}', but {}", directory.string(), failure));
  return result;
}

} // namespace

Command run_command() {
  return {.name = "run",
          .summary = "Run an SDPD scene",
          .example = "mesobridge run workflows/scenes/argon-1000K.toml -o out/argon --set particles.K=50",
          .declare = [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            app.add_option("scene", options->scene, "The scene file")->required()->type_name("SCENE.toml");
            app.add_option("--set", options->set,
                           "Override a key of the scene: section.key=value; repeatable")
                ->type_name("KEY=VALUE")
                ->expected(1)
                ->take_all();
            app.add_flag("--resume", options->resume, "Go on from the checkpoint in the output directory");
            app.add_flag("--verbose", options->verbose,
                         "Show the lines of thermodynamics that log.txt gets, also on a terminal");
            return [options](Context& context) { return run(*options, context); };
          }};
}

} // namespace mesobridge::workflows
