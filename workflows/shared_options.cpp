#include "workflows/shared_options.hpp"

namespace mesobridge::workflows {

CLI::Option* add_preset(CLI::App& app, std::string& preset, std::string const& text) {
  return app.add_option("--preset", preset, text)->check(CLI::IsMember({"quick", "standard", "paper"}));
}

void add_scene(CLI::App& app, std::string& scene, std::vector<std::string>& set) {
  app.add_option("scene", scene, "The scene file")->required()->type_name("SCENE.toml");
  app.add_option("--set", set, "Override a key of the scene: section.key=value; repeatable")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
}

void add_blob_file(CLI::App& app, std::filesystem::path& file) {
  app.add_option("file", file, "What `md star-melt` or `cg blobs` wrote")->required()->type_name("FILE.h5");
}

void add_started_by_ourselves(CLI::App& app, bool& started_by_ourselves) {
  app.add_flag("--started-by-ourselves", started_by_ourselves)->group("");
}

void add_restarts(CLI::App& app, std::int64_t& checkpoint_every, bool& resume, bool& started_by_ourselves) {
  app.add_option("--checkpoint-every", checkpoint_every, "Steps between checkpoints");
  app.add_flag("--resume", resume, "Go on from the checkpoint in the output folder");
  add_started_by_ourselves(app, started_by_ourselves);
}

void add_choice(CLI::App& app, std::string const& name, std::string& value,
                std::vector<std::string> const& choices, std::string const& text) {
  app.add_option(name, value, text)->check(CLI::IsMember(choices))->capture_default_str();
}

void add_list(CLI::App& app, std::string const& name, std::vector<double>& values, std::string const& text) {
  app.add_option(name, values, text)->delimiter(',')->default_str("");
}

} // namespace mesobridge::workflows
