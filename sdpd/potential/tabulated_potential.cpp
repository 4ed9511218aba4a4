#include "sdpd/potential/tabulated_potential.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
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
    require(std::isfinite(r[k]) && (k == 0 ? r[k] >= 0 : r[k] > r[k - 1]),
            "distance in the potential's table", r[k], "must be >= 0, finite and larger than the one before");
    require(std::isfinite(u[k]), "energy in the potential's table", u[k], "must be finite");
    require(force.empty() || std::isfinite(force[k]), "force in the potential's table",
            force.empty() ? 0 : force[k], "must be finite");
  }
}

/// Two slopes between which -f of a row must lie, but for a margin.
struct SlopeRange {
  double low, high;
};

/// The slope of u at row k by what its neighbours say: the secants on both sides enclose the slope of a curve
/// that bends one way, and a quarter of the change of secants about them, which exceeds the third
/// derivative's part h^2 u_rrr/6, makes room for one that bends both ways. At an end the secants are
/// extrapolated. Digits lost in printing u and f widen the range.
SlopeRange slope_range(std::vector<double> const& r, std::vector<double> const& u,
                       std::vector<double> const& force, std::size_t k) {
  constexpr double printed = 5e-6; // relative: six digits
  auto const secant = [&](std::size_t i) { return (u[i + 1] - u[i]) / (r[i + 1] - r[i]); };
  std::size_t const last = r.size() - 2, left = k == 0 ? 0 : k - 1, right = std::min(k, last);
  double a = secant(left), b = secant(right), bend = std::abs(a - b);
  if (left == right) {
    b = a + 1.5 * (a - secant(k == 0 ? 1 : last - 1));
    bend = 2 * std::abs(a - b);
  }
  if (left > 0)
    bend = std::max(bend, std::abs(secant(left) - secant(left - 1)));
  if (right < last)
    bend = std::max(bend, std::abs(secant(right + 1) - secant(right)));
  double const spacing = std::min(r[left + 1] - r[left], r[right + 1] - r[right]);
  double const u_near = std::max({std::abs(u[left]), std::abs(u[left + 1]), std::abs(u[right + 1])});
  double const margin = 0.25 * bend + printed * (2 * u_near / spacing + std::abs(force[k]));
  return {std::min(a, b) - margin, std::max(a, b) + margin};
}

/// Refuses a column of forces that is not -du/dr: the spline through both would be another potential.
void check_slopes(std::vector<double> const& r, std::vector<double> const& u,
                  std::vector<double> const& force) {
  for (std::size_t k = 0; k < force.size(); ++k) {
    auto const slopes = slope_range(r, u, force, k);
    if (-force[k] >= slopes.low && -force[k] <= slopes.high)
      continue;
    bool const reversed = force[k] >= slopes.low && force[k] <= slopes.high;
    throw InputError(
        fmt::format("row {} of the potential's table (r = {}): f = {:.6g}, but -du/dr lies between {:.6g} "
                    "and {:.6g} by the energies of its rows{}",
                    k + 1, r[k], force[k], -slopes.high, -slopes.low,
                    reversed ? ": the sign of f is wrong, a repulsion has f > 0" : ""));
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
  check_slopes(r, u, force);
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
