#pragma once
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

inline bool has_open_faces(Scene const& scene) {
  return scene.box.x == "open" || scene.box.y == "open" || scene.box.z == "open";
}

/// Whether something keeps the fluid from equilibrium: regions, a reaction, a piston, walls that slide, a
/// body force, or vacuum beyond an open face. It has then no one temperature that could be the scene's.
inline bool is_driven(Scene const& scene) {
  auto const& box = scene.box;
  return !scene.regions.empty() || scene.features().reacts || box.piston || box.piston_file ||
         !box.piston_times.empty() || box.slide || box.body_force || has_open_faces(scene);
}

} // namespace mesobridge::workflows
