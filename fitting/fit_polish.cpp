#include "fitting/fit_search.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <memory>

namespace mesobridge::fitting {
namespace {

/// What GSL's callbacks see: residuals as functions of angles, u = (1 + sin x)/2, of the moving coordinates.
/// No step leaves the bounds so, which would end the search beside them.
struct Moving {
  FitCoordinates const& coordinates;
  Eigen::VectorXd origin;
  std::vector<Eigen::Index> const& moving;

  Eigen::VectorXd point(gsl_vector const* x) const {
    Eigen::VectorXd u = origin;
    for (std::size_t k = 0; k < moving.size(); ++k)
      u[moving[k]] = 0.5 * (1 + std::sin(gsl_vector_get(x, k)));
    return u;
  }
  /// A bound is no angle to start from: every slope vanishes there.
  static double angle(double u) {
    constexpr double off_bound = 1e-6;
    return std::asin(2 * std::clamp(u, off_bound, 1 - off_bound) - 1);
  }
};

int residuals(gsl_vector const* x, void* data, gsl_vector* f) {
  auto const& self = *static_cast<Moving const*>(data);
  auto const r = self.coordinates.feasible_residuals(self.point(x));
  // A step into the forbidden is worse than any other: the trust region shrinks.
  constexpr double forbidden = 1e10;
  for (std::size_t i = 0; i < f->size; ++i)
    gsl_vector_set(f, i, r ? (*r)[static_cast<Eigen::Index>(i)] : forbidden);
  return GSL_SUCCESS;
}

int jacobian(gsl_vector const* x, void* data, gsl_matrix* J) {
  auto const& self = *static_cast<Moving const*>(data);
  auto const u = self.point(x);
  auto const r = self.coordinates.residuals(u);
  if (!r)
    return GSL_EDOM;
  Eigen::MatrixXd full;
  try {
    full = self.coordinates.jacobian(u, *r);
  } catch (std::runtime_error const&) { // exceptions must not cross GSL, which is C
    return GSL_EDOM;
  }
  for (std::size_t k = 0; k < J->size2; ++k) {
    double const slope = 0.5 * std::cos(gsl_vector_get(x, k));
    for (std::size_t i = 0; i < J->size1; ++i)
      gsl_matrix_set(J, i, k, slope * full(static_cast<Eigen::Index>(i), self.moving[k]));
  }
  return GSL_SUCCESS;
}

} // namespace

std::vector<Eigen::Index> moving_coordinates(FitCoordinates const& coordinates, Eigen::VectorXd const& u) {
  constexpr double on_bound = 1e-7;
  auto const r = coordinates.known_residuals(u);
  Eigen::VectorXd const gradient = coordinates.jacobian(u, r).transpose() * r;
  std::vector<Eigen::Index> moving;
  for (Eigen::Index k = 0; k < u.size(); ++k) {
    bool const held = (u[k] <= on_bound && gradient[k] > 0) || (u[k] >= 1 - on_bound && gradient[k] < 0);
    if (!held)
      moving.push_back(k);
  }
  return moving;
}

Eigen::VectorXd polish(FitCoordinates const& coordinates, Eigen::VectorXd const& from,
                       std::vector<Eigen::Index> const& moving) {
  if (moving.empty())
    return from;
  auto const start = coordinates.known_residuals(from);
  Moving problem{coordinates, from, moving};
  auto const n = static_cast<std::size_t>(start.size()), p = moving.size();
  using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;
  gsl_set_error_handler_off(); // what fails says so by its status; GSL would end the program
  auto const parameters = gsl_multifit_nlinear_default_parameters();
  Workspace const work(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, n, p),
                       gsl_multifit_nlinear_free);
  if (!work)
    return from;
  gsl_multifit_nlinear_fdf fdf{};
  fdf.f = residuals;
  fdf.df = jacobian;
  fdf.n = n;
  fdf.p = p;
  fdf.params = &problem;
  std::vector<double> x;
  for (auto const k : moving)
    x.push_back(Moving::angle(from[k]));
  auto const view = gsl_vector_const_view_array(x.data(), p);
  bool const begun = gsl_multifit_nlinear_init(&view.vector, &fdf, work.get()) == GSL_SUCCESS;
  int info = 0;
  constexpr std::size_t most = 200;
  constexpr double x_tolerance = 1e-12, gradient_tolerance = 1e-14;
  if (begun)
    gsl_multifit_nlinear_driver(most, x_tolerance, gradient_tolerance, 0, nullptr, nullptr, &info,
                                work.get());
  coordinates.throw_if_stopped();
  if (!begun)
    return from;
  Eigen::VectorXd const to = problem.point(work->x);
  auto const reached = coordinates.feasible_residuals(to);
  return reached && reached->squaredNorm() <= start.squaredNorm() ? to : from;
}

} // namespace mesobridge::fitting
