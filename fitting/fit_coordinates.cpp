#include "fitting/fit_coordinates.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::fitting {
namespace {

void check(Parameter const& p) {
  auto const what = [&](char const* end) { return fmt::format("parameter {} {}", p.name, end); };
  require(std::isfinite(p.start), what("start"), p.start, "must be finite");
  if (!p.free)
    return;
  require(std::isfinite(p.lower) && std::isfinite(p.upper) && p.lower < p.upper, what("bounds"),
          fmt::format("{}:{}", p.lower, p.upper), "the lower must be below the upper one");
  require(p.start >= p.lower && p.start <= p.upper, what("start"), p.start,
          fmt::format("must be within its bounds {}:{}", p.lower, p.upper));
  require(!p.logarithmic || p.lower > 0, what("lower bound"), p.lower,
          "must be > 0: it is searched by its logarithm");
}

double to_unit(Parameter const& p, double value) {
  return p.logarithmic ? std::log(value / p.lower) / std::log(p.upper / p.lower)
                       : (value - p.lower) / (p.upper - p.lower);
}

double from_unit(Parameter const& p, double u) {
  double const value =
      p.logarithmic ? p.lower * std::exp(u * std::log(p.upper / p.lower)) : p.lower + u * (p.upper - p.lower);
  // Round-off may carry what lies on a bound beyond it.
  return u >= 0 && u <= 1 ? std::min(std::max(value, p.lower), p.upper) : value;
}

double slope(Parameter const& p, double u) {
  return p.logarithmic ? from_unit(p, u) * std::log(p.upper / p.lower) : p.upper - p.lower;
}

} // namespace

FitCoordinates::FitCoordinates(FitProblem const& problem, std::function<bool()> keep_going)
    : problem_(problem), keep_going_(std::move(keep_going)) {
  for (std::size_t i = 0; i < problem.parameters.size(); ++i) {
    check(problem.parameters[i]);
    if (!problem.parameters[i].free)
      continue;
    if (problem.parameters[i].linear)
      linear_.push_back(size());
    free_.push_back(static_cast<Eigen::Index>(i));
  }
}

double FitCoordinates::value(Eigen::Index coordinate, double u) const {
  return from_unit(problem_.parameters[free_[coordinate]], u);
}

double FitCoordinates::unit(Eigen::Index coordinate, double value) const {
  return to_unit(problem_.parameters[free_[coordinate]], value);
}

bool FitCoordinates::stopped() const {
  stopped_ = stopped_ || (keep_going_ && !keep_going_());
  return stopped_;
}

void FitCoordinates::throw_if_stopped() const {
  if (stopped())
    throw Interrupted("the fit was interrupted before its end: nothing is written");
}

Eigen::VectorXd FitCoordinates::known_residuals(Eigen::VectorXd const& u) const {
  auto const r = residuals(u);
  throw_if_stopped();
  if (!r)
    throw std::logic_error("a point of a fit without residuals");
  return *r;
}

Eigen::VectorXd FitCoordinates::start() const {
  Eigen::VectorXd u(size());
  for (Eigen::Index k = 0; k < size(); ++k)
    u[k] = to_unit(problem_.parameters[free_[k]], problem_.parameters[free_[k]].start);
  return u;
}

Eigen::VectorXd FitCoordinates::values(Eigen::VectorXd const& u) const {
  Eigen::VectorXd x(problem_.parameters.size());
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] = problem_.parameters[i].start;
  for (Eigen::Index k = 0; k < size(); ++k)
    x[free_[k]] = from_unit(problem_.parameters[free_[k]], u[k]);
  return x;
}

Eigen::VectorXd FitCoordinates::slopes(Eigen::VectorXd const& u) const {
  Eigen::VectorXd d(size());
  for (Eigen::Index k = 0; k < size(); ++k)
    d[k] = slope(problem_.parameters[free_[k]], u[k]);
  return d;
}

std::optional<Eigen::VectorXd> FitCoordinates::residuals(Eigen::VectorXd const& u) const {
  ++evaluations_;
  if (stopped())
    return std::nullopt;
  if ((u.array() < 0).any() || (u.array() > 1).any())
    return std::nullopt;
  try {
    auto r = problem_.residuals(values(u));
    if (!r.allFinite())
      return std::nullopt;
    return r;
  } catch (PhysicsError const&) {
    return std::nullopt;
  } catch (InputError const&) {
    return std::nullopt;
  }
}

std::optional<Eigen::VectorXd> FitCoordinates::constraints(Eigen::VectorXd const& u) const {
  if (!problem_.constraints)
    return Eigen::VectorXd();
  try {
    return problem_.constraints(values(u));
  } catch (PhysicsError const&) {
    return std::nullopt;
  } catch (InputError const&) {
    return std::nullopt;
  }
}

bool FitCoordinates::feasible(Eigen::VectorXd const& u) const {
  return feasible_residuals(u).has_value();
}

std::optional<Eigen::VectorXd> FitCoordinates::feasible_residuals(Eigen::VectorXd const& u) const {
  auto r = residuals(u);
  if (!r)
    return std::nullopt;
  auto const c = constraints(u);
  if (!c || !(c->array() > 0).all())
    return std::nullopt;
  return r;
}

void FitCoordinates::refuse_edge(Eigen::Index coordinate, Eigen::VectorXd const& u) const {
  throw_if_stopped();
  throw PhysicsError(fmt::format("the model has no answer on either side of {} = {:.6g}",
                                 problem_.parameters[free_[coordinate]].name,
                                 value(coordinate, u[coordinate])));
}

Eigen::MatrixXd FitCoordinates::jacobian(Eigen::VectorXd const& u, Eigen::VectorXd const& r) const {
  // Truncation and round-off of a central difference are both near 1e-10 of the residual here.
  constexpr double step = 1e-5;
  Eigen::MatrixXd J(r.size(), size());
  for (Eigen::Index k = 0; k < size(); ++k) {
    Eigen::VectorXd above = u, below = u;
    above[k] += step, below[k] -= step;
    auto const r_above = residuals(above), r_below = residuals(below);
    if (r_above && r_below)
      J.col(k) = (*r_above - *r_below) / (2 * step);
    else if (r_above)
      J.col(k) = (*r_above - r) / step;
    else if (r_below)
      J.col(k) = (r - *r_below) / step;
    else
      refuse_edge(k, u);
  }
  return J;
}

} // namespace mesobridge::fitting
