#pragma once
#include "fitting/riemann.hpp"
#include "sdpd/method/settings.hpp"
#include "workflows/report/report.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/store/store.hpp"

namespace mesobridge::workflows {

/// Two half spaces that meet at a plane across the box (fitting/README.md, Eq. (F16)), in the scene's units.
struct RiemannProblem {
  int axis;        ///< 0, 1, 2 for x, y, z
  double membrane; ///< where they meet
  double length;   ///< of the box
  fitting::RiemannSolution exact;
  std::array<bool, 2> held; ///< whether a wall at rest is at the lower and the upper end, and fluid at rest
  double margin;            ///< how far the interaction carries the influence of an end, > 0

  /// The exact flow, at rest relative to the box.
  fitting::FlowState at(double place, double time) const;
  /// The first time at which a wave comes to an end of the box, or of a fluid that has left that end.
  double end() const;
  /// Between these places no influence of the ends is felt.
  std::pair<double, double> undisturbed(double time) const;
};

/// The problem that a scene of SDPD begins with; nothing when its regions are no two slabs beside each other,
/// or when it has no solution.
std::optional<RiemannProblem> riemann_problem(Scene const& scene, sdpd::SimulationSettings const& settings);

/// A profile at one instant, at the middles of slices of the box, beside the exact flow.
struct RiemannComparison {
  double time;
  std::vector<double> place, rho, u, P, T;
  std::vector<fitting::FlowState> exact = {}; ///< means over the slices
  /// Means of |ours - exact| over the undisturbed part of the box, in the scene's units (the norm L1).
  double rho_error = 0, u_error = 0, P_error = 0;
};

/// The same with the exact flow.
RiemannComparison compare(RiemannProblem const& problem, RiemannComparison profile);

/// The last profile of a run before a wave came to an end of the box. Nothing without a profile of velocity,
/// rho, T_int and P along the problem's axis.
std::optional<RiemannComparison> compare(RiemannProblem const& problem, Store const& store,
                                         Scene const& scene, OutputUnits const& units);

/// `riemann_problem` with the time, the exact P and u at the contact and the errors.
void put_riemann(Json& json, RiemannProblem const& problem, RiemannComparison const& found,
                 OutputUnits const& units);

/// The four profiles with the exact ones, and a table of the errors. `name` tells the drawings of several
/// apart.
Section riemann_section(RiemannComparison const& found, OutputUnits const& units,
                        std::string const& name = "");

} // namespace mesobridge::workflows
