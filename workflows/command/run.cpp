#include "workflows/command/list.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/sdpd/equilibrium_report.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {
namespace {

struct Options {
  std::string scene;
  std::vector<std::string> set;
  bool resume = false;
};

Result run(Options const& options, Context& context) {
  auto overrides = options.set;
  if (context.options.seed)
    overrides.push_back(fmt::format("run.seed={}", *context.options.seed));
  Scene const scene = load_scene(options.scene, overrides);
  std::filesystem::path const fallback =
      scene.output.directory.value_or("out/" + std::filesystem::path(options.scene).stem().string());
  auto const directory = context.output_directory(fallback);
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
