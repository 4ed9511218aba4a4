#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/lammps_plugin/input.hpp"
#include "workflows/sdpd/resumption.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

struct LammpsPluginOptions {
  std::string run;
  std::int64_t steps = 10000;
};

Result write_input(LammpsPluginOptions const& options, Context const& context) {
  RunFolder const folder(options.run);
  require(folder.has_checkpoint() && std::filesystem::exists(folder.scene()), "RUN", options.run,
          "must be a folder of `run` with its checkpoint and scene.toml");
  auto const stored = read_checkpoint(folder.checkpoint());
  if (!stored.warning.empty())
    context.log->warn("warning: {}", stored.warning);
  auto const scene = resumed_scene(load_run(folder.scene(), {}, 1, Engine::lammps), stored.scene,
                                   stored.inputs, folder.checkpoint());
  auto const directory = context.output_directory("out/lammps-plugin");
  write_lammps_input(directory, scene, stored, options.steps);
  Result result;
  result.json = {{"input", (directory / "in.fluid").string()},
                 {"particles", stored.checkpoint.particles.size()},
                 {"step", stored.checkpoint.step}};
  result.text = fmt::format("{} particles from step {} of the run; how to go on: {}",
                            stored.checkpoint.particles.size(), stored.checkpoint.step,
                            (directory / "README.md").string());
  return result;
}

void declare(CLI::App& app, LammpsPluginOptions& options) {
  app.add_option("RUN", options.run, "Folder of a run, whose last checkpoint LAMMPS goes on from")
      ->required();
  app.add_option("--steps", options.steps, "Steps that the input runs")
      ->check(CLI::Range(std::int64_t{1}, (std::int64_t{1} << 31) - 1).description(""))
      ->type_name("NUMBER");
}

} // namespace

extern Declaration const lammps_plugin_command = with_options<LammpsPluginOptions, declare, write_input>;

} // namespace mesobridge::workflows
