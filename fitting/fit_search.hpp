#pragma once
#include "fitting/fit_coordinates.hpp"

namespace mesobridge::fitting {

/// The best values of the linear parameters while the others stand at u (variable projection: Golub and
/// Pereyra, SIAM J. Numer. Anal. 10 (1973) 413): Gauss-Newton steps within the bounds, which are exact at
/// once where the residuals are linear. They begin at the lower bounds, where the terms of these parameters
/// vanish; nothing where the model has no answer there.
std::optional<Eigen::VectorXd> project_linear(FitCoordinates const& coordinates, Eigen::VectorXd const& u);

/// The best point of a controlled random search over the unit box (Kaelo and Ali, J. Optim. Theory Appl. 130
/// (2006) 253; NLopt's CRS2), the linear parameters projected out. Points without an answer, or that a
/// constraint forbids, count as infinitely bad. Throws PhysicsError when no point is feasible.
Eigen::VectorXd search_globally(FitCoordinates const& coordinates, int evaluations, std::uint64_t seed);

/// Sequential quadratic programming from a feasible point, with bounds and constraints (NLopt's SLSQP). The
/// result is feasible and not worse.
Eigen::VectorXd descend_constrained(FitCoordinates const& coordinates, Eigen::VectorXd const& from);

/// Levenberg-Marquardt (GSL) from a feasible point in the coordinates `moving`; the others stay. The result
/// is feasible and not worse.
Eigen::VectorXd polish(FitCoordinates const& coordinates, Eigen::VectorXd const& from,
                       std::vector<Eigen::Index> const& moving);

/// Where a search ended, and whether it came to its end.
struct SearchEnd {
  Eigen::VectorXd u;
  bool settled;
};

/// The minimum on the constraints that forbid a better one: augmented Lagrangian (Powell; Hestenes), each
/// round polished as above. The result is feasible and, but for a distance of 5e-7 from the constraints, not
/// worse.
SearchEnd descend_to_constraints(FitProblem const& problem, FitCoordinates const& coordinates,
                                 Eigen::VectorXd const& from);

/// The coordinates that no bound holds: those farther than 1e-7 from 0 and 1, and those on a bound from which
/// |residuals|^2 falls inwards.
std::vector<Eigen::Index> moving_coordinates(FitCoordinates const& coordinates, Eigen::VectorXd const& u);

} // namespace mesobridge::fitting
