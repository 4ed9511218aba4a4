#include "md/error.hpp"
#include "workflows/command/list.hpp"
#include "workflows/scene/scene.hpp"
#include "workflows/sdpd/cost_estimate.hpp"
#include "workflows/sdpd/disk_estimate.hpp"
#include "workflows/sdpd/settings.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

constexpr double typical_dt = 0.1; ///< reduced: stands for one that is still to be found

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
  bool keys = false;
};

Result check(Options const& options, Context const& context) {
  if (options.keys)
    return {.json = {{"keys", scene_keys_text()}}, .text = scene_keys_text(), .complaint = ""};
  require(!options.scene.empty(), "SCENE", "''", "a scene file is needed (or --keys)");
  Scene const scene = load_scene(options.scene, options.overrides);
  auto settings = settings_of(scene, context.options.threads.value_or(available_threads()));
  if (scene.scheme.dt.automatic)
    settings.dt = typical_dt;
  sdpd::check(settings);
  auto const cost = estimate_cost(scene, settings);
  auto const disk = estimate_disk(scene);
  auto const resolved = resolved_toml(scene);
  Result result;
  result.json = {{"scene", options.scene},
                 {"valid", true},
                 {"resolved", resolved},
                 {"estimated_neighbours", cost.neighbours},
                 {"estimated_time_s", cost.seconds},
                 {"estimated_memory_bytes", cost.bytes},
                 {"estimated_disk_bytes", disk.total()},
                 {"estimated_disk_results_bytes", disk.results},
                 {"estimated_disk_trajectories_bytes", disk.trajectories},
                 {"estimated_disk_checkpoint_bytes", disk.checkpoint}};
  result.text =
      resolved +
      fmt::format(
          "\n# about {} on {} thread(s), {:.3g} MB of memory, {:.3g} MB on the disk; {:.0f} neighbours a "
          "particle",
          duration_text(cost.seconds), settings.threads, cost.bytes / 1e6, disk.total() / 1e6,
          cost.neighbours);
  return result;
}

} // namespace

Command check_command() {
  return {.name = "check",
          .summary = "Validate a scene, print it as resolved and estimate its cost; runs nothing",
          .example = "mesobridge check workflows/scenes/argon-1000K.toml --set particles.K=1000",
          .declare = [](CLI::App& app) -> Command::Action {
            auto options = std::make_shared<Options>();
            app.add_option("scene", options->scene, "The scene file")->type_name("SCENE.toml");
            app.add_option("--set", options->overrides, "Replace a value: section.key=value")
                ->type_name("KEY=VALUE")
                ->expected(1)
                ->take_all();
            app.add_flag("--keys", options->keys, "Explain all keys of a scene");
            return [options](Context& context) { return check(*options, context); };
          }};
}

} // namespace mesobridge::workflows
