#include "sdpd/pair/tabulated_potential.hpp"
#include "md/error.hpp"
#include <gsl/gsl_interp.h>
#include <memory>

namespace mesobridge::sdpd {
namespace {

struct ValueAndSlope {
  double value, slope;
};

/// The cubic with these values and slopes at t = 0 and t = 1, `width` apart.
Row hermite(ValueAndSlope const& a, ValueAndSlope const& b, double width) {
  double const rise = b.value - a.value, s_a = a.slope * width, s_b = b.slope * width;
  return Row{a.value, s_a, 3 * rise - 2 * s_a - s_b, s_a + s_b - 2 * rise};
}

void check(std::vector<double> const& r, std::vector<double> const& u, std::vector<double> const& force) {
  require(r.size() >= 4 && u.size() == r.size() && (force.empty() || force.size() == r.size()),
          "points of the potential's table", r.size(), "must be at least 4, each with an energy");
  for (std::size_t k = 0; k < r.size(); ++k) {
    require(std::isfinite(r[k]) && r[k] > (k == 0 ? 0 : r[k - 1]), "distance in the potential's table", r[k],
            "must be > 0, finite and larger than the one before");
    require(std::isfinite(u[k]), "energy in the potential's table", u[k], "must be finite");
    require(force.empty() || std::isfinite(force[k]), "force in the potential's table",
            force.empty() ? 0 : force[k], "must be finite");
  }
}

/// The natural cubic spline through the points.
class CubicSpline {
 public:
  CubicSpline(std::vector<double> const& r, std::vector<double> const& u)
      : r_(r), u_(u), interpolation_(gsl_interp_alloc(gsl_interp_cspline, r.size()), gsl_interp_free) {
    gsl_interp_init(interpolation_.get(), r.data(), u.data(), r.size());
  }
  ValueAndSlope operator()(double r) const {
    double const x = std::min(std::max(r, r_.front()), r_.back()); // the last point, but for round-off
    return {gsl_interp_eval(interpolation_.get(), r_.data(), u_.data(), x, nullptr),
            gsl_interp_eval_deriv(interpolation_.get(), r_.data(), u_.data(), x, nullptr)};
  }

 private:
  std::vector<double> const &r_, &u_;
  std::unique_ptr<gsl_interp, decltype(&gsl_interp_free)> interpolation_;
};

/// Hermite's spline through the points and their slopes.
class HermiteSpline {
 public:
  HermiteSpline(std::vector<double> const& r, std::vector<double> const& u, std::vector<double> const& force)
      : r_(r), u_(u), force_(force) {}
  ValueAndSlope operator()(double r) const {
    auto const next = std::upper_bound(r_.begin() + 1, r_.end() - 1, r);
    auto const k = static_cast<std::size_t>(next - r_.begin()) - 1;
    double const width = r_[k + 1] - r_[k], t = (r - r_[k]) / width;
    Row const c = hermite({u_[k], -force_[k]}, {u_[k + 1], -force_[k + 1]}, width);
    return {c[0] + t * (c[1] + t * (c[2] + t * c[3])), (c[1] + t * (2 * c[2] + t * 3 * c[3])) / width};
  }

 private:
  std::vector<double> const &r_, &u_, &force_;
};

UniformTable tabulate(std::vector<double> const& r, std::vector<double> const& u,
                      std::vector<double> const& force) {
  check(r, u, force);
  auto on_even_points = [&](auto const& spline) {
    return UniformTable(r.front(), r.back(), [&](double at, double width) {
      auto a = spline(at), b = spline(at + width);
      a.value -= u.back(), b.value -= u.back();
      return hermite(a, b, width);
    });
  };
  return force.empty() ? on_even_points(CubicSpline(r, u)) : on_even_points(HermiteSpline(r, u, force));
}

} // namespace

TabulatedPotential::TabulatedPotential(std::vector<double> const& r, std::vector<double> const& u,
                                       std::vector<double> const& force)
    : table_(tabulate(r, u, force)) {}

} // namespace mesobridge::sdpd
