#include "workflows/sdpd/resumption.hpp"
#include "fitting/toml_reader.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/scene/resolved_lines.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/sdpd/scene_inputs.hpp"
#include "workflows/sdpd/viscosity_of_pairs.hpp"
#include "workflows/study/automatic_dt.hpp"
#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/ranges.h>
#include <map>

namespace mesobridge::workflows {
namespace {

/// The values of a resolved scene as they stand there, by the keys' paths.
using Values = std::map<std::string, std::string>;

Values values_of(std::string const& resolved) {
  Values values;
  for_each_resolved_line(resolved, [&](auto const&, auto const& path, auto const& value) {
    if (!path.empty())
      values[path] = value;
  });
  return values;
}

template <class Number>
std::optional<Number> number_of(Values const& values, std::string const& key) {
  auto const found = values.find(key);
  Number result{};
  if (found == values.end())
    return std::nullopt;
  auto const& text = found->second;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  if (error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return result;
}

std::optional<std::string> text_of(Values const& values, std::string const& key) {
  auto const found = values.find(key);
  if (found == values.end())
    return std::nullopt;
  return fitting::parse_toml("text = " + found->second, key)["text"].value<std::string>();
}

/// As resolved scenes have them: with a unit in SI.
std::optional<double> quantity_of(Values const& values, std::string const& key, Dimension dimension) {
  auto const found = values.find(key);
  if (found == values.end() || !found->second.starts_with('"'))
    return number_of<double>(values, key);
  return parse_quantity(*text_of(values, key), dimension);
}

std::int64_t steps_of(Values const& values, std::string const& key) {
  return number_of<std::int64_t>(values, key).value_or(0);
}

/// Keys that a resumed run may have other values of.
bool may_differ(std::string const& key, Values const& stored) {
  constexpr std::array free{"title",
                            "run.steps",
                            "run.trajectory_every",
                            "run.vtkhdf_every",
                            "run.xyz_every",
                            "run.checkpoint_every",
                            "run.checkpoint_minutes",
                            "profile.every",
                            "histogram.every",
                            "series.every",
                            "film.every",
                            "output.directory"};
  if (std::ranges::find(free, key) != free.end())
    return true;
  for (std::string const series : {"profile", "histogram", "series"}) // that had not begun
    if (key.starts_with(series + ".") && steps_of(stored, series + ".every") == 0)
      return true;
  return key.starts_with("film.") && !stored.contains("film.quantity");
}

std::int64_t past_instants_every(Values const& stored) {
  Scene::Run past;
  past.steps = steps_of(stored, "run.steps");
  past.instant_every = steps_of(stored, "run.instant_every");
  return instants_every(past);
}

std::int64_t past_film_every(Values const& stored) {
  Scene past;
  past.run.steps = steps_of(stored, "run.steps");
  past.film.quantity = text_of(stored, "film.quantity");
  past.film.every = steps_of(stored, "film.every");
  return film_every(past);
}

/// What the run found itself, and the intervals of the instants and of the film.
Scene with_findings(Scene scene, Values const& stored) {
  if (scene.scheme.dt.automatic) {
    Scene past;
    past.scheme.dt = {.value = number_of<double>(stored, "scheme.dt").value_or(0)};
    past.scheme.dt_chosen_for = text_of(stored, "scheme.dt_chosen_for");
    past.scheme.diffusion_share = number_of<double>(stored, "scheme.diffusion_share");
    past.scheme.diffusion_share_se = number_of<double>(stored, "scheme.diffusion_share_se");
    scene = with_stored_time_step(scene, past);
  }
  if (wants_calibration(scene)) {
    scene.particles.density_scale = number_of<double>(stored, "particles.density_scale");
    scene.particles.density_self = number_of<double>(stored, "particles.density_self");
  }
  if (wants_trials_of_viscosity(scene))
    scene.transport.eta_pairs = quantity_of(stored, "transport.eta_pairs", Dimension::viscosity);
  if (scene.run.instant_every == 0 && instants_every(scene.run) != past_instants_every(stored))
    scene.run.instant_every = past_instants_every(stored);
  if (auto const past = past_film_every(stored);
      past > 0 && scene.film.every == 0 && film_every(scene) != past)
    scene.film.every = past;
  return scene;
}

std::string short_hash(std::string const& hash) {
  return hash.substr(0, 12);
}

/// Whether the key names an input whose content is known, which then says more than its path. Throws
/// InputError when that has changed.
bool is_same_file(std::string const& key, std::vector<SceneFile> const& files, Values const& stored,
                  std::vector<InputFile> const& inputs, std::string const& place) {
  auto const now = std::ranges::find(files, key, &SceneFile::key);
  if (now == files.end())
    return false;
  auto const path = text_of(stored, key);
  auto const before =
      std::ranges::find_if(inputs, [&](InputFile const& input) { return path == input.path.string(); });
  if (before == inputs.end())
    return false;
  auto const hash = sha256_of_file(now->path);
  if (hash != before->sha256)
    throw InputError(
        fmt::format("'{}' ({}) is not what the run in '{}' began with: its SHA-256 was {}... and is "
                    "{}... now; put the old content back, or begin anew with --force or in "
                    "another folder",
                    now->path.string(), key, place, short_hash(before->sha256), short_hash(hash)));
  return true;
}

/// "run.seed was 1 and is 2", of the resolved scenes.
std::optional<std::string> difference(SceneKey const& key, Scene const& scene, Values const& stored) {
  Scene fresh;
  fresh.units = scene.units, fresh.method = scene.method;
  auto const known = stored.find(key.path());
  auto const before = known != stored.end()                     ? std::optional(known->second)
                      : key.required || key.section == "method" ? std::nullopt
                                                                : value_text(key, fresh),
             now = value_text(key, scene);
  bool const in_neither = known == stored.end() && !now; // a model has it in their place
  if (before == now || in_neither)
    return std::nullopt;
  return fmt::format("{} was {} and is {}", key.path(), before.value_or("not given"),
                     now.value_or("not given"));
}

} // namespace

PastRun past_run(StoredCheckpoint stored) {
  auto const values = values_of(stored.scene);
  auto every = [&](char const* key) { return steps_of(values, key); };
  FrameSchedules const frames{every("run.trajectory_every"), every("run.vtkhdf_every"),
                              every("run.xyz_every")};
  return {std::move(stored), frames};
}

Scene resumed_scene(Scene scene, std::string const& stored_scene, std::vector<InputFile> const& stored_inputs,
                    std::filesystem::path const& place) {
  auto const stored = values_of(stored_scene);
  scene = with_findings(std::move(scene), stored);
  auto const files = scene_files(scene);
  std::vector<std::string> differences;
  for (auto const& key : all_keys(scene)) {
    auto const path = key.path();
    bool const same_instants =
        path == "run.instant_every" && instants_every(scene.run) == past_instants_every(stored);
    if (same_instants || may_differ(path, stored) ||
        is_same_file(path, files, stored, stored_inputs, place.parent_path().string()))
      continue;
    if (auto const found = difference(key, scene, stored))
      differences.push_back(*found);
  }
  for (auto const& [path, value] : stored)
    if (path == fmt::format("region.{}.shape", scene.regions.size() + 1))
      differences.push_back(fmt::format("{} was {} and is not given", path, value));
  if (differences.empty())
    return scene;
  throw InputError(fmt::format(
      "'{}' was written by another scene than this one: {}. A run that is resumed may "
      "change run.steps, title, output.directory, and the schedules of trajectories, "
      "profiles, histograms, series, films and checkpoints; for anything else begin anew with --force "
      "or in another folder",
      place.string(), fmt::join(differences, ", ")));
}

} // namespace mesobridge::workflows
