#pragma once
#include "workflows/provenance.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// The keys of a scene that name files, with those that this scene names: "fluid.eos" and a fitted model.
struct SceneFile {
  std::string key;
  std::filesystem::path path;
};
std::vector<SceneFile> scene_files(Scene const& scene);

/// The same with their present content. Throws InputError if one cannot be read.
std::vector<InputFile> scene_inputs(Scene const& scene);

/// The hashes of all, a line each with its key: what is made of the scene is made of these, too.
std::string input_hashes(Scene const& scene);

/// What trials of a scene's fluid are made of: not the length and the output of its run.
std::string fluid_identity(Scene const& scene);

} // namespace mesobridge::workflows
