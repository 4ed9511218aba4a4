#include "workflows/beside/run_numbers.hpp"
#include "md/error.hpp"
#include "workflows/json_file.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {
namespace {

constexpr std::string_view error_ending = "_se";

constexpr int deepest = 16; // of objects within objects

void collect(Json const& object, std::string const& before, RunNumbers& run, int depth = 0) {
  require(depth <= deepest, "summary.json of", run.name,
          fmt::format("must not have more than {} objects within each other", deepest));
  for (auto const& [key, value] : object.items()) {
    if (value.is_object())
      collect(value, before + key + ".", run, depth + 1);
    auto const error = object.find(key + std::string(error_ending));
    if (value.is_number() && error != object.end() && error->is_number()) {
      require(error->get<double>() >= 0, run.name + ": " + key + "_se", error->get<double>(), "must be >= 0");
      run.numbers.push_back({before + key, {value.get<double>(), error->get<double>()}});
    }
  }
}

std::vector<std::pair<std::string, std::string>> keys_of(std::filesystem::path const& file) {
  if (!std::filesystem::exists(file))
    return {};
  auto const scene = parse_scene(read_text_file(file), file);
  std::vector<std::pair<std::string, std::string>> keys;
  for (auto const& key : all_keys(scene))
    if (auto const text = value_text(key, scene); text && key.belongs_to(scene.method.name))
      keys.emplace_back(key.path(), *text);
  return keys;
}

} // namespace

cg::Estimate const* RunNumbers::number(std::string const& wanted) const {
  auto const found = std::ranges::find(numbers, wanted, [](auto const& one) { return one.first; });
  return found == numbers.end() ? nullptr : &found->second;
}

RunNumbers read_run_numbers(std::filesystem::path const& folder) {
  require(std::filesystem::is_directory(folder), "RUN", folder.string(),
          "must be a folder that `run` or another command with a summary.json has written");
  auto const file = folder / "summary.json";
  require(std::filesystem::exists(file), "RUN", folder.string(),
          "holds no summary.json: no finished run, or one of another program");
  RunNumbers run{.name = folder.string(), .folder = folder};
  auto const json = read_json(file);
  require(json.is_object(), "RUN", file.string(), "must hold a JSON object");
  collect(json, "", run);
  require(!run.numbers.empty(), "RUN", file.string(),
          "holds no number with a standard error outside of lists");
  run.keys = keys_of(folder / "scene.toml");
  return run;
}

} // namespace mesobridge::workflows
