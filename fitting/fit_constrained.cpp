#include "fitting/fit_search.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::fitting {
namespace {

/// How far inside the constraints the search stays, so that its end is feasible.
constexpr double margin = 5e-7;

/// The problem with its constraints as further residuals sqrt(mu) max(0, margin - c + lambda/mu).
struct Lagrangian {
  FitProblem const& problem;
  Eigen::VectorXd lambda;
  double mu;

  FitProblem augmented() const {
    return {problem.parameters, [this](Eigen::VectorXd const& values) {
              Eigen::VectorXd const r = problem.residuals(values), c = problem.constraints(values);
              Eigen::VectorXd all(r.size() + c.size());
              all << r, std::sqrt(mu) * (margin - c.array() + lambda.array() / mu).max(0).matrix();
              return all;
            }};
  }
};

} // namespace

SearchEnd descend_to_constraints(FitProblem const& problem, FitCoordinates const& coordinates,
                                 Eigen::VectorXd const& from) {
  Eigen::VectorXd u = from;
  Lagrangian lagrangian{problem, Eigen::VectorXd::Zero(coordinates.constraints(from).value().size()),
                        1 + coordinates.known_residuals(from).squaredNorm()};
  FitProblem const augmented = lagrangian.augmented();
  FitCoordinates const penalised(augmented, coordinates.keep_going());
  double violation = std::numeric_limits<double>::infinity();
  constexpr int most = 40;
  constexpr double settled = 1e-9, stiffening = 4;
  bool done = false;
  for (int round = 0; round < most && !done; ++round) {
    Eigen::VectorXd const next = polish(penalised, u, moving_coordinates(penalised, u));
    auto const c = coordinates.constraints(next);
    if (!c)
      break;
    Eigen::VectorXd const excess = (margin - c->array()).matrix();
    double const worst = excess.cwiseMax(0).maxCoeff(), moved = (next - u).norm();
    lagrangian.lambda = (lagrangian.lambda + lagrangian.mu * excess).cwiseMax(0);
    if (worst > violation / stiffening)
      lagrangian.mu *= stiffening;
    violation = worst;
    u = next;
    done = moved < settled && worst < 0.5 * margin;
  }
  double const start = coordinates.known_residuals(from).squaredNorm();
  auto const end = coordinates.feasible_residuals(u);
  double const price_of_margin = 2 * margin * lagrangian.lambda.sum();
  if (end && end->squaredNorm() <= start + 2 * price_of_margin)
    return {u, done};
  return {from, false};
}

} // namespace mesobridge::fitting
