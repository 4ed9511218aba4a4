#include "md/error.hpp"
#include "workflows/built_in.hpp"
#include "workflows/command/options.hpp"
#include "workflows/nearest.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/terminal.hpp"
#include "workflows/text_file.hpp"
#include <sstream>

namespace mesobridge::workflows {
namespace {

std::string name_of(BuiltIn const& scene) {
  return std::filesystem::path(scene.name).stem().string();
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (auto const& scene : built_in_scenes())
    all.push_back(name_of(scene));
  return all;
}

std::string text_of(std::string const& name) {
  for (auto const& scene : built_in_scenes())
    if (name_of(scene) == name)
      return std::string(scene.content);
  refuse_unknown("scene", name, names());
}

std::string comment(std::string const& text) {
  constexpr std::size_t columns = 98;
  std::string lines = "# ";
  for (char const c : wrapped(text, columns, 0))
    lines += c == '\n' ? "\n# " : std::string(1, c);
  return lines + "\n";
}

/// A model that a scene names as a file, and where it looks for it.
struct ModelOfScene {
  std::filesystem::path file;
  std::string_view content;
  bool was_there = false;
};

std::vector<ModelOfScene> models_of(std::string const& scene, std::filesystem::path const& folder) {
  std::vector<ModelOfScene> models;
  for (auto const& model : built_in_model_files()) {
    auto const place = std::filesystem::path("models") / model.name, file = folder / place;
    if (scene.find(fmt::format("\"{}\"", place.string())) != scene.npos)
      models.push_back({file, model.content, std::filesystem::exists(std::filesystem::symlink_status(file))});
  }
  return models;
}

/// What is there already, such as a fit of the user's own, stays.
void write_missing(std::vector<ModelOfScene> const& models) {
  for (auto const& model : models)
    if (!model.was_there) {
      std::filesystem::create_directories(model.file.parent_path());
      write_text_file(model.file, model.content);
    }
}

/// The lines of a scene, each key below its meaning and what it allows. The scene's models are in their
/// places beside `file`.
std::string commented(std::string const& name, std::filesystem::path const& file) {
  auto const text = text_of(name);
  auto const units = parse_scene(text, file).units;
  auto result = comment(fmt::format("The scene that `mesobridge new {}` writes. `mesobridge check` prints it "
                                    "with every key that is left out here; `mesobridge check --keys` "
                                    "explains them all.",
                                    name));
  std::string section;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("["))
      section = line.substr(1, line.find(']') - 1);
    for (auto const& key : scene_keys())
      if (key.section == section && line.starts_with(key.name + " = "))
        result += "\n" + comment(key.meaning) + comment(key.allowed(units));
    result += line + "\n";
  }
  return result;
}

Result write_scene(std::string const& name, Context const& context) {
  auto const scene = text_of(name);
  auto const file = context.options.output.value_or(name + ".toml");
  require(!std::filesystem::exists(std::filesystem::symlink_status(file)), "--output", file.string(),
          "is there already: take another name, or remove it");
  auto const models = models_of(scene, file.parent_path());
  write_missing(models);
  write_text_file(file, commented(name, file));
  Result result{.json = {{"file", file.string()}, {"scene", name}}, .text = "", .complaint = ""};
  for (auto const& model : models) {
    result.json["models"].push_back(model.file.string());
    result.text +=
        fmt::format("{}{}\n", model.file.string(), model.was_there ? " was there already and stays" : "");
  }
  result.text += fmt::format(
      "{0}\n`mesobridge check {0}` estimates what it costs, `mesobridge run {0}` runs it", file.string());
  return result;
}

void declare(CLI::App& app, std::string& name) {
  add_word(app, "name", name, names());
}

} // namespace

extern Declaration const new_command = with_options<std::string, declare, write_scene>;

} // namespace mesobridge::workflows
