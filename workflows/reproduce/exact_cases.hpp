#pragma once
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// One half of a tube at the start, SI.
struct TubeSide {
  std::string eos; ///< a built-in material
  double rho, T, u;
};

/// A tube whose halves meet in the middle, and its Riemann problem has an exact solution.
struct TubeCase {
  std::string name, title;
  TubeSide left, right;
};

/// Sod's tube, Toro's second and third problem, Noh's, and water against air.
std::vector<TubeCase> const& tube_cases();

/// A scene without noise of `n` particles along the tube, equally far apart in both halves, with a viscosity
/// that makes the strongest shock two or three particles wide, until four fifths of the time in which the
/// first wave comes to an end.
Scene tube_scene(TubeCase const& of, std::int64_t n);

} // namespace mesobridge::workflows
