#include "workflows/command/list.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/sdpd/equilibrium_report.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/study/automatic_dt.hpp"
#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> set;
  bool resume = false;
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

Result run(Options const& options, Context& context) {
  auto overrides = options.set;
  if (context.options.seed)
    overrides.push_back(fmt::format("run.seed={}", *context.options.seed));
  Scene scene = load_scene(options.scene, overrides);
  std::filesystem::path const fallback =
      scene.output.directory.value_or("out/" + std::filesystem::path(options.scene).stem().string());
  auto const directory = context.output_directory(fallback);
  if (scene.scheme.dt.automatic)
    scene = with_time_step(scene, options.resume, directory, context);
  auto const total = scene.run.equilibrate + scene.run.steps;
  auto progress = context.progress(scene.title, static_cast<double>(total));
  auto const done = run_scene(scene, {.directory = directory,
                                      .threads = context.options.threads.value_or(available_threads()),
                                      .resume = options.resume,
                                      .command = context.command_line(),
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
  result.text = (directory / "report.html").string();
  return result;
}

} // namespace

Command run_command() {
  return {.name = "run",
          .summary = "Run an SDPD scene",
          .example = "mesobridge run workflows/scenes/argon-1000K.toml -o out/argon --set particles.K=50",
          .declare = [](CLI::App& app) {
            auto options = std::make_shared<Options>();
            app.add_option("scene", options->scene, "scene file (TOML)")->required();
            app.add_option("--set", options->set,
                           "override a key of the scene: section.key=value; repeatable")
                ->expected(1)
                ->take_all();
            app.add_flag("--resume", options->resume, "go on from the checkpoint in the output directory");
            return [options](Context& context) { return run(*options, context); };
          }};
}

} // namespace mesobridge::workflows
