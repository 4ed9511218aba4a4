#include "md/error.hpp"
#include "workflows/command/list.hpp"
#include "workflows/scene/scene.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct Options {
  std::string scene;
  std::vector<std::string> overrides;
  bool keys = false;
};

Result check(Options const& options) {
  if (options.keys)
    return {.json = {{"keys", scene_keys_text()}}, .text = scene_keys_text(), .complaint = ""};
  require(!options.scene.empty(), "SCENE", "''", "a scene file is needed (or --keys)");
  auto const resolved = resolved_toml(load_scene(options.scene, options.overrides));
  return {.json = {{"scene", options.scene}, {"valid", true}, {"resolved", resolved}},
          .text = resolved,
          .complaint = ""};
}

} // namespace

Command check_command() {
  return {.name = "check",
          .summary = "Validate a scene and print it as resolved; runs nothing",
          .example = "mesobridge check workflows/scenes/argon-1000K.toml --set particles.K=1000",
          .declare = [](CLI::App& app) -> Command::Action {
            auto options = std::make_shared<Options>();
            app.add_option("scene", options->scene, "The scene file")->type_name("SCENE.toml");
            app.add_option("--set", options->overrides, "Replace a value: section.key=value")
                ->type_name("KEY=VALUE")
                ->expected(1)
                ->take_all();
            app.add_flag("--keys", options->keys, "Explain all keys of a scene");
            return [options](Context&) { return check(*options); };
          }};
}

} // namespace mesobridge::workflows
