#include "fitting/fit_search.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

namespace mesobridge::fitting {
namespace {

Eigen::VectorXd as_vector(unsigned n, double const* x) {
  return Eigen::Map<Eigen::VectorXd const>(x, n);
}

/// The best feasible point that a search has seen: NLopt may end on another one.
struct Best {
  double chi_2 = std::numeric_limits<double>::infinity();
  Eigen::VectorXd u;

  void offer(double candidate, Eigen::VectorXd const& at) {
    if (candidate < chi_2)
      chi_2 = candidate, u = at;
  }
};

/// The local search's view of the problem.
struct Descent {
  FitCoordinates const& coordinates;
  double start_chi_2;
  Best best;

  double objective(Eigen::VectorXd const& u, double* gradient) {
    auto const r = coordinates.residuals(u);
    if (!r) { // a step that went too far: worse than any point worth keeping, so that it is shortened
      if (gradient)
        std::fill_n(gradient, u.size(), 0.0);
      return 1e3 * (start_chi_2 + 1);
    }
    if (gradient)
      Eigen::Map<Eigen::VectorXd>(gradient, u.size()) = 2 * coordinates.jacobian(u, *r).transpose() * *r;
    if (coordinates.feasible(u))
      best.offer(r->squaredNorm(), u);
    return r->squaredNorm();
  }

  /// NLopt asks for constraints <= 0.
  void constraints(unsigned m, double* result, Eigen::VectorXd const& u, double* gradient) const {
    Eigen::VectorXd const bad = Eigen::VectorXd::Constant(m, -1);
    Eigen::VectorXd const at = coordinates.constraints(u).value_or(bad);
    Eigen::Map<Eigen::VectorXd>(result, m) = -at;
    if (!gradient)
      return;
    constexpr double step = 1e-6;
    for (Eigen::Index k = 0; k < u.size(); ++k) {
      Eigen::VectorXd shifted = u;
      double const h = u[k] + step <= 1 ? step : -step;
      shifted[k] += h;
      Eigen::VectorXd const there = coordinates.constraints(shifted).value_or(at);
      for (unsigned i = 0; i < m; ++i)
        gradient[i * u.size() + k] = -(there[i] - at[i]) / h;
    }
  }
};

/// The global search's view: coordinates of the parameters that are not linear.
struct GlobalSearch {
  FitCoordinates const& coordinates;
  std::vector<Eigen::Index> searched;
  Best best;

  explicit GlobalSearch(FitCoordinates const& of) : coordinates(of), searched{}, best{} {
    for (Eigen::Index k = 0; k < of.size(); ++k)
      if (std::ranges::find(of.linear(), k) == of.linear().end())
        searched.push_back(k);
  }
  std::vector<double> start() const {
    Eigen::VectorXd const u = coordinates.start();
    std::vector<double> x;
    for (auto const k : searched)
      x.push_back(u[k]);
    return x;
  }
  Eigen::VectorXd point(double const* x) const {
    Eigen::VectorXd u = coordinates.start();
    for (std::size_t k = 0; k < searched.size(); ++k)
      u[searched[k]] = x[k];
    return coordinates.linear().empty() ? u : project_linear(coordinates, u).value_or(u);
  }
  double chi_2(double const* x) {
    auto const u = point(x);
    auto const r = coordinates.feasible_residuals(u);
    double const found = r ? r->squaredNorm() : HUGE_VAL;
    best.offer(found, u);
    return found;
  }
};

} // namespace

Eigen::VectorXd search_globally(FitCoordinates const& coordinates, int evaluations, std::uint64_t seed) {
  GlobalSearch search(coordinates);
  auto const n = static_cast<unsigned>(search.searched.size());
  if (n == 0)
    return search.point(nullptr);
  nlopt::srand(seed);
  nlopt::opt crs(nlopt::GN_CRS2_LM, n);
  crs.set_lower_bounds(0);
  crs.set_upper_bounds(1);
  crs.set_maxeval(evaluations);
  crs.set_ftol_rel(1e-4); // the local stages take it from there
  crs.set_min_objective([](unsigned, double const* x, double*,
                           void* data) { return static_cast<GlobalSearch*>(data)->chi_2(x); },
                        &search);
  std::vector<double> u = search.start();
  double found = 0;
  crs.optimize(u, found);
  coordinates.throw_if_stopped();
  if (search.best.u.size() == 0)
    throw PhysicsError(
        fmt::format("none of {} points within the bounds gives a model that reaches all data and is physical",
                    evaluations));
  return search.best.u;
}

Eigen::VectorXd descend_constrained(FitCoordinates const& coordinates, Eigen::VectorXd const& from) {
  double const start = coordinates.known_residuals(from).squaredNorm();
  Descent descent{coordinates, start, {}};
  descent.best.offer(start, from);
  auto const n = static_cast<unsigned>(from.size());
  nlopt::opt slsqp(nlopt::LD_SLSQP, n);
  slsqp.set_lower_bounds(0);
  slsqp.set_upper_bounds(1);
  slsqp.set_maxeval(200);
  slsqp.set_ftol_rel(1e-10);
  slsqp.set_min_objective(
      [](unsigned size, double const* x, double* gradient, void* data) {
        return static_cast<Descent*>(data)->objective(as_vector(size, x), gradient);
      },
      &descent);
  if (auto const m = coordinates.constraints(from).value().size(); m > 0)
    slsqp.add_inequality_mconstraint(
        [](unsigned count, double* result, unsigned size, double const* x, double* gradient, void* data) {
          static_cast<Descent*>(data)->constraints(count, result, as_vector(size, x), gradient);
        },
        &descent, std::vector<double>(m, 0.0));
  std::vector<double> u(from.data(), from.data() + n);
  double found = 0;
  try {
    slsqp.optimize(u, found);
  } catch (nlopt::roundoff_limited const&) {
    // As near as round-off allows: the best point stands.
  } catch (std::runtime_error const&) {
    // SLSQP gives up where its quadratic model is singular; the polish goes on from the best point.
  }
  coordinates.throw_if_stopped();
  return descent.best.u;
}

} // namespace mesobridge::fitting
