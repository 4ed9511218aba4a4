#include "workflows/sdpd/scene_inputs.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {

std::vector<SceneFile> scene_files(Scene const& scene) {
  std::vector<SceneFile> files;
  auto add = [&](char const* key, std::optional<std::string> const& name) {
    if (name && std::filesystem::is_regular_file(*name)) // a built-in model is none
      files.push_back({key, *name});
  };
  add("fluid.eos", scene.fluid.eos);
  add("reaction.product", scene.reaction.product);
  add("particles.model", scene.particles.model);
  add("potential.file", scene.potential.file);
  add("friction.file", scene.friction.file);
  add("conduction.file", scene.conduction.file);
  add("internal_energy.model", scene.internal_energy.model);
  add("box.piston_file", scene.box.piston_file);
  return files;
}

std::vector<InputFile> scene_inputs(Scene const& scene) {
  std::vector<InputFile> inputs;
  for (auto const& [key, path] : scene_files(scene))
    inputs.emplace_back(path);
  return inputs;
}

std::string input_hashes(Scene const& scene) {
  std::string text;
  for (auto const& [key, path] : scene_files(scene))
    text += fmt::format("\n{} {}", key, sha256_of_file(path));
  return text;
}

std::string fluid_identity(Scene const& scene) {
  Scene fluid = scene;
  fluid.title.clear();
  fluid.particles.calibration_steps = 0;
  fluid.run = {.seed = scene.run.seed, .thermostat = scene.run.thermostat, .bath_rate = scene.run.bath_rate};
  fluid.profile = {}, fluid.histogram = {}, fluid.series = {}, fluid.film = {};
  fluid.output = {};
  return sha256(fmt::format("{}\n{}{}", resolved_toml(fluid), git_commit(), input_hashes(scene)));
}

} // namespace mesobridge::workflows
