#pragma once
#include "fitting/fit_coordinates.hpp"

namespace mesobridge::fitting {

/// The best point of a controlled random search over the unit box (Kaelo and Ali, J. Optim. Theory Appl. 130
/// (2006) 253; NLopt's CRS2). Points without an answer, or that a constraint forbids, count as infinitely
/// bad. Throws PhysicsError when no point is feasible.
Eigen::VectorXd search_globally(FitCoordinates const& coordinates, int evaluations, std::uint64_t seed);

/// Sequential quadratic programming from a feasible point, with bounds and constraints (NLopt's SLSQP). The
/// result is feasible and not worse.
Eigen::VectorXd descend_constrained(FitCoordinates const& coordinates, Eigen::VectorXd const& from);

/// Levenberg-Marquardt (GSL) from a feasible point in the coordinates `moving`; the others stay. The result
/// is feasible and not worse.
Eigen::VectorXd polish(FitCoordinates const& coordinates, Eigen::VectorXd const& from,
                       std::vector<Eigen::Index> const& moving);

} // namespace mesobridge::fitting
