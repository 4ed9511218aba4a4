#include "workflows/shared_options.hpp"
#include "md/molecule_forces.hpp"
#include <algorithm>
#include <cctype>
#include <fmt/ranges.h>

namespace mesobridge::workflows {

CLI::Option* add_preset(CLI::App& app, std::string& preset, std::string const& text) {
  return app.add_option("--preset", preset, text)->check(CLI::IsMember({"quick", "standard", "paper"}));
}

void add_word(CLI::App& app, std::string const& name, std::string& word,
              std::vector<std::string> const& known) {
  auto type = name;
  std::ranges::transform(type, type.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  app.add_option(name, word, fmt::format("One of {}", fmt::join(known, ", ")))->required()->type_name(type);
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

void add_molecule_files(CLI::App& app, std::filesystem::path& data, std::filesystem::path& forces,
                        md::MoleculeStyles& styles) {
  app.add_option("data", data, "LAMMPS data file of equal molecules")->required()->type_name("FILE");
  app.add_option("--settings", forces, "Their force field as LAMMPS's commands: pair_style, bond_coeff ...")
      ->required()
      ->type_name("FILE");
  app.add_option("--units", styles.units, "LAMMPS's unit style (default: the settings' or lj)")
      ->type_name("NAME");
  app.add_option("--atom-style", styles.atom_style,
                 "bond, angle, molecular or full (default: what the files say)")
      ->type_name("NAME");
}

void add_choice(CLI::App& app, std::string const& name, std::string& value,
                std::vector<std::string> const& choices, std::string const& text) {
  app.add_option(name, value, text)->check(CLI::IsMember(choices))->capture_default_str();
}

void add_list(CLI::App& app, std::string const& name, std::vector<double>& values, std::string const& text) {
  app.add_option(name, values, text)->delimiter(',')->default_str("");
}

} // namespace mesobridge::workflows
