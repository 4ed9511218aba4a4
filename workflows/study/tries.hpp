#pragma once
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// Reduced time steps and times of studies that do not say otherwise.
struct Tries {
  std::vector<double> compared; ///< time steps of a trade-off
  std::vector<double> dt;       ///< of a search for the time step of a run
  double time;                  ///< that each trial of such a search samples
  double shorter_start;         ///< by how much the equilibrium in front of the trials takes shorter steps
};

/// Soft particles forget faster than particles of fluid and want shorter steps.
inline Tries tries_of(Scene const& scene) {
  if (scene.features().densities)
    return {{0.05, 0.1, 0.15, 0.2, 0.3}, {0.03, 0.05, 0.08, 0.12, 0.2, 0.3, 0.4}, 200, 1};
  return {{0.01, 0.02, 0.03, 0.04, 0.06}, {0.01, 0.015, 0.02, 0.03, 0.04, 0.06}, 110, 5};
}

} // namespace mesobridge::workflows
