#include "fitting/fit.hpp"
#include "fitting/fit_search.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_statistics_double.h>
#include <limits>
#include <random>

namespace mesobridge::fitting {
namespace {

/// From a feasible point.
Eigen::VectorXd polished(FitCoordinates const& coordinates, Eigen::VectorXd const& u) {
  auto const data = coordinates.known_residuals(u).size();
  require(data >= u.size(), "number of data", data,
          fmt::format("must be at least that of the free parameters, {}", u.size()));
  return polish(coordinates, u, moving_coordinates(coordinates, u));
}

/// Whether the fit could still improve: the Gauss-Newton step in the coordinates that no bound holds.
bool no_descent_left(Eigen::MatrixXd const& J, Eigen::VectorXd const& r,
                     std::vector<Eigen::Index> const& moving) {
  if (moving.empty())
    return true;
  Eigen::MatrixXd const part = J(Eigen::all, moving);
  // Along axes without information neither residuals nor gradients change.
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(part, Eigen::ComputeThinU | Eigen::ComputeThinV);
  svd.setThreshold(1e-7);
  Eigen::VectorXd const step = svd.solve(r);
  constexpr double improvement = 1e-6;
  return (part * step).squaredNorm() < improvement * (1 + r.squaredNorm());
}

bool at_minimum(FitCoordinates const& coordinates, Eigen::VectorXd const& u) {
  auto const r = coordinates.known_residuals(u);
  return no_descent_left(coordinates.jacobian(u, r), r, moving_coordinates(coordinates, u));
}

double chi_2_at(FitCoordinates const& coordinates, Eigen::VectorXd const& u) {
  return coordinates.known_residuals(u).squaredNorm();
}

/// The best end of several starts and how many came to it.
struct Starts {
  Eigen::VectorXd best;
  int all, at_best;
};

/// Independent searches, each polished: one alone may contract about a side valley.
Starts search_from_anywhere(FitCoordinates const& coordinates, FitOptions const& options) {
  constexpr int searches = 8;
  std::vector<double> chi_2;
  Eigen::VectorXd best;
  for (int k = 0; k < searches; ++k) {
    auto const u =
        polished(coordinates, search_globally(coordinates, std::max(1, options.global_evaluations / searches),
                                              options.seed + static_cast<std::uint64_t>(k)));
    double const found = chi_2_at(coordinates, u);
    if (chi_2.empty() || found < *std::ranges::min_element(chi_2))
      best = u;
    chi_2.push_back(found);
  }
  constexpr double same = 1e-3;
  double const least = *std::ranges::min_element(chi_2);
  auto const at_best = std::ranges::count_if(chi_2, [&](double x) { return x < least + same * (1 + least); });
  return {best, searches, static_cast<int>(at_best)};
}

SearchEnd search(FitProblem const& problem, FitCoordinates const& coordinates, Starts const& starts) {
  Eigen::VectorXd u = starts.best;
  auto const residuals = coordinates.feasible_residuals(u);
  coordinates.throw_if_stopped();
  if (!residuals)
    throw PhysicsError(
        "at the start values the model does not reach all data, or is not physical: give others "
        "or search globally");
  u = descend_constrained(coordinates, polished(coordinates, u));
  u = polished(coordinates, u);
  bool const settled = at_minimum(coordinates, u);
  return problem.constraints && !settled ? descend_to_constraints(problem, coordinates, u)
                                         : SearchEnd{u, settled};
}

/// Principal axes of the Gauss-Newton Hessian J^T J by singular values of J: squaring would lose half the
/// digits.
std::vector<FitAxis> axes_of(Eigen::MatrixXd const& J) {
  Eigen::JacobiSVD<Eigen::MatrixXd> const svd(J, Eigen::ComputeThinU | Eigen::ComputeFullV);
  // Differences are good to about 1e-9 of the largest: smaller singular values are noise.
  double const noise = 1e-9 * svd.singularValues()(0);
  std::vector<FitAxis> axes;
  for (Eigen::Index k = 0; k < J.cols(); ++k) {
    double const value = svd.singularValues()(k);
    axes.push_back(
        {value > noise ? 1 / value : std::numeric_limits<double>::infinity(), svd.matrixV().col(k)});
  }
  return axes;
}

/// The covariance as L L^T, without forming it (it would lose half of the digits).
Eigen::MatrixXd covariance_factor(std::vector<FitAxis> const& axes, Eigen::VectorXd const& slopes) {
  Eigen::MatrixXd spread(slopes.size(), slopes.size());
  for (Eigen::Index k = 0; k < spread.cols(); ++k)
    spread.col(k) = std::min(axes[k].sd, FitAxis::of_bounds) * slopes.cwiseProduct(axes[k].components);
  Eigen::HouseholderQR<Eigen::MatrixXd> const qr(spread.transpose());
  Eigen::MatrixXd const upper = qr.matrixQR().triangularView<Eigen::Upper>();
  return upper.transpose();
}

bool near_constraint(FitCoordinates const& coordinates, Eigen::VectorXd const& u) {
  auto const c = coordinates.constraints(u).value();
  return c.size() > 0 && c.minCoeff() < 1e-6;
}

std::string listed(std::vector<std::string> const& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

double FitOutcome::se(Eigen::Index parameter) const {
  auto const found = std::ranges::find(free, parameter);
  if (found == free.end())
    return 0;
  auto const k = found - free.begin();
  return covariance_factor.row(k).norm();
}

Eigen::MatrixXd FitOutcome::correlation() const {
  Eigen::MatrixXd const rows = covariance_factor.rowwise().normalized();
  return rows * rows.transpose();
}

double FitOutcome::se_of(std::function<double(Eigen::VectorXd const&)> const& function) const {
  constexpr double step = 1e-3; // of a standard error
  double sum = 0;
  for (Eigen::Index k = 0; k < covariance_factor.cols(); ++k) {
    auto const at = [&](double steps) -> std::optional<double> {
      Eigen::VectorXd shifted = values;
      shifted(free) += steps * step * covariance_factor.col(k);
      try {
        return function(shifted);
      } catch (PhysicsError const&) {
        return std::nullopt;
      } catch (InputError const&) {
        return std::nullopt;
      }
    };
    // One-sided at the edge of what the model allows.
    auto const above = at(1), below = at(-1);
    if (!above && !below)
      throw PhysicsError("the fit lies on the edge of what the model allows: its errors cannot be told");
    double const rise = above && below ? 0.5 * (*above - *below)
                        : above        ? *above - function(values)
                                       : function(values) - *below;
    sum += rise * rise / (step * step);
  }
  return std::sqrt(sum);
}

bool FitOutcome::determined(Eigen::Index parameter) const {
  auto const found = std::ranges::find(free, parameter);
  if (found == free.end())
    return true;
  auto const k = found - free.begin();
  double variance = 0; // of the coordinate, by the data alone
  for (auto const& axis : axes)
    if (double const share = axis.components[k] * axis.components[k]; share > 1e-6)
      variance += share * axis.sd * axis.sd;
  return variance < FitAxis::of_bounds * FitAxis::of_bounds;
}

std::vector<std::string> FitOutcome::undetermined() const {
  std::vector<std::string> sentences;
  for (auto const& axis : axes) {
    if (axis.determined())
      continue;
    std::vector<std::string> names;
    double const largest = axis.components.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < axis.components.size(); ++k)
      if (std::abs(axis.components[k]) > 0.3 * largest)
        names.push_back(parameters[free[k]].name);
    sentences.push_back(
        names.size() == 1
            ? fmt::format(
                  "The data do not determine {}: all that is known of it are its bounds. Fix it, or narrow "
                  "its bounds.",
                  names[0])
            : fmt::format(
                  "Of {} the data determine only combinations: along one of them nothing is known but the "
                  "bounds. Fix one of these parameters, or narrow its bounds.",
                  listed(names)));
  }
  return sentences;
}

FitOutcome fit(FitProblem const& problem, FitOptions const& options) {
  FitCoordinates const coordinates(problem, options.keep_going);
  require(coordinates.size() > 0, "free parameters", 0, "at least one parameter must be free");
  require(options.global_evaluations >= 0, "evaluations of the global search", options.global_evaluations,
          "must be >= 0");
  auto const starts = options.global_evaluations > 0 ? search_from_anywhere(coordinates, options)
                                                     : Starts{coordinates.start(), 1, 1};
  auto const [u, settled] = search(problem, coordinates, starts);
  FitOutcome outcome{.parameters = problem.parameters,
                     .free = coordinates.free(),
                     .values = coordinates.values(u),
                     .covariance_factor = {},
                     .axes = {},
                     .residuals = coordinates.known_residuals(u),
                     .at_bound = {}};
  auto const moving = moving_coordinates(coordinates, u);
  for (Eigen::Index k = 0; k < u.size(); ++k)
    if (std::ranges::find(moving, k) == moving.end())
      outcome.at_bound.push_back(outcome.free[k]);
  Eigen::MatrixXd const J = coordinates.jacobian(u, outcome.residuals);
  outcome.axes = axes_of(J);
  outcome.covariance_factor = covariance_factor(outcome.axes, coordinates.slopes(u));
  outcome.constrained = near_constraint(coordinates, u);
  outcome.converged = settled;
  outcome.evaluations = coordinates.evaluations();
  outcome.starts = starts.all, outcome.starts_at_best = starts.at_best;
  return outcome;
}

double Bootstrap::se(Eigen::Index column) const {
  Eigen::VectorXd const values_of_one = values.col(column);
  return gsl_stats_sd(values_of_one.data(), 1, values_of_one.size());
}

double Bootstrap::quantile(Eigen::Index column, double p) const {
  Eigen::VectorXd sorted = values.col(column);
  std::sort(sorted.begin(), sorted.end());
  return gsl_stats_quantile_from_sorted_data(sorted.data(), 1, sorted.size(), p);
}

Bootstrap bootstrap(FitProblem const& problem, FitOutcome const& best, int repeats, std::uint64_t seed,
                    std::function<bool()> const& keep_going) {
  require(repeats >= 2, "bootstrap repeats", repeats, "must be at least 2");
  FitProblem again = problem;
  for (auto const i : best.free)
    again.parameters[i].start = best.values[i];
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd noise(best.residuals.size());
  // Data drawn from the best fit have the residuals of the old data, minus theirs at the best fit, plus
  // noise.
  again.residuals = [&](Eigen::VectorXd const& x) {
    return Eigen::VectorXd(problem.residuals(x) - best.residuals + noise);
  };
  Bootstrap result{Eigen::MatrixXd(repeats, best.free.size())};
  Eigen::Index done = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (auto& component : noise)
      component = normal(generator);
    try {
      result.values.row(done) = fit(again, {.seed = seed, .global_evaluations = 0, .keep_going = keep_going})
                                    .values(best.free)
                                    .transpose();
      ++done;
    } catch (PhysicsError const&) {
      ++result.failed;
    }
  }
  result.values.conservativeResize(done, Eigen::NoChange);
  if (done < 2)
    throw PhysicsError(fmt::format("{} of {} refits of the bootstrap failed", result.failed, repeats));
  return result;
}

} // namespace mesobridge::fitting
