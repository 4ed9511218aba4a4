#pragma once
#include "workflows/scene/scene.hpp"
#include "workflows/sdpd/riemann_problem.hpp"

namespace mesobridge::workflows {

/// One half of a tube at the start, SI.
struct TubeSide {
  std::string eos; ///< a built-in material
  double rho, T, u;
};

/// What the tests of another program of smoothed particles ask of the same tube: that the mean over its
/// particles of |u - exact|, as far from the membrane as a signal at `reach` has come, is less than `below`.
struct StatedError {
  std::string program, where; ///< the latter: who says so, and with how many particles
  double reach, unit;         ///< velocities, SI; the latter is the other program's 1
  double below;               ///< in that unit
};

/// A tube whose halves meet in the middle, and its Riemann problem has an exact solution.
struct TubeCase {
  std::string name, title;
  TubeSide left, right;
  std::optional<StatedError> stated = std::nullopt;
};

/// That mean of a profile, in the other program's unit; a slice counts by its mass, as its particles would.
double error_as_stated(StatedError const& stated, RiemannComparison const& found, double membrane);

/// Sod's tube, Toro's second and third problem, Noh's, water against air, and a tube milder than Sod's.
std::vector<TubeCase> const& tube_cases();

/// A scene without noise of `n` particles along the tube, equally far apart in both halves, with a viscosity
/// that makes the strongest shock two or three particles wide, until four fifths of the time in which the
/// first wave comes to an end.
Scene tube_scene(TubeCase const& of, std::int64_t n);

} // namespace mesobridge::workflows
