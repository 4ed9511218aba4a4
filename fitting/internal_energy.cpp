#include "fitting/internal_energy.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <gsl/gsl_interp.h>
#include <limits>

namespace mesobridge::fitting {
namespace {

void check_points(std::vector<double> const& x, std::vector<double> const& y, char const* name,
                  double above) {
  require(x.size() >= 4 && x.size() == y.size(), fmt::format("points of {}", name), x.size(),
          "must be at least 4, as many as values");
  for (std::size_t k = 0; k < x.size(); ++k)
    require(std::isfinite(x[k]) && x[k] > (k == 0 ? above : x[k - 1]), name, x[k],
            "must be finite, within bounds and larger than the one before");
}

void refuse_outside(double value, double low, double high, char const* name) {
  if (!(value >= low && value <= high))
    throw PhysicsError(fmt::format("{} {:.6g} is outside the table of the internal energy, {:.6g} ... {:.6g}",
                                   name, value, low, high));
}

using Interpolation = std::unique_ptr<gsl_interp, decltype(&gsl_interp_free)>;
Interpolation interpolate(gsl_interp_type const* type, std::vector<double> const& x,
                          std::vector<double> const& y) {
  Interpolation interpolation(gsl_interp_alloc(type, x.size()), gsl_interp_free);
  gsl_interp_init(interpolation.get(), x.data(), y.data(), x.size());
  return interpolation;
}

std::size_t interval_of(std::vector<double> const& points, double x) {
  return static_cast<std::size_t>(std::upper_bound(points.begin() + 1, points.end() - 1, x) -
                                  points.begin()) -
         1;
}

} // namespace

ConstantHeatCapacity::ConstantHeatCapacity(double C) : C_(C) {
  require(C > 0 && std::isfinite(C), "heat capacity of a particle, in k_B", C, "must be > 0 and finite");
}

double ConstantHeatCapacity::entropy(double T) const {
  return C_ * std::log(C_ * T);
}

double ConstantHeatCapacity::temperature(double eps, double) const {
  if (!(eps > 0))
    throw PhysicsError(fmt::format("internal energy {:.6g} k_B T must be positive", eps));
  return eps / C_;
}

TabulatedHeatCapacity::TabulatedHeatCapacity(std::vector<double> T, std::vector<double> C, double eps_min)
    : T_(std::move(T)), C_(std::move(C)), eps_{eps_min}, S_{0} {
  check_points(T_, C_, "temperature in the table of C(T)", 0);
  require(std::isfinite(eps_min), "internal energy at the first temperature", eps_min, "must be finite");
  for (double const c : C_)
    require(c > 0 && std::isfinite(c), "heat capacity in the table, in k_B", c, "must be > 0 and finite");
  auto const spline = interpolate(gsl_interp_steffen, T_, C_);
  auto slope = [&](std::size_t k) {
    return gsl_interp_eval_deriv(spline.get(), T_.data(), C_.data(), T_[k], nullptr);
  };
  for (std::size_t k = 0; k + 1 < T_.size(); ++k) {
    double const width = T_[k + 1] - T_[k], rise = (C_[k + 1] - C_[k]) / width, a = slope(k),
                 b = slope(k + 1);
    cubic_.push_back({C_[k], a, (3 * rise - 2 * a - b) / width, (a + b - 2 * rise) / (width * width)});
    eps_.push_back(eps_[k] + energy_in(k, width));
    S_.push_back(S_[k] + entropy_in(k, width));
  }
}

std::size_t TabulatedHeatCapacity::interval(double T) const {
  refuse_outside(T, T_.front(), T_.back(), "temperature");
  return interval_of(T_, T);
}

/// Integral of C over x.
double TabulatedHeatCapacity::energy_in(std::size_t k, double x) const {
  auto const [a, b, c, d] = cubic_[k];
  return x * (a + x * (b / 2 + x * (c / 3 + x * (d / 4))));
}

/// Integral of C/T: with T_k + x in place of T, C/T = q(x) + C(-T_k)/(T_k + x), q a polynomial.
double TabulatedHeatCapacity::entropy_in(std::size_t k, double x) const {
  auto const [a, b, c, d] = cubic_[k];
  double const T = T_[k], q_2 = d, q_1 = c - T * q_2, q_0 = b - T * q_1, rest = a - T * q_0;
  return x * (q_0 + x * (q_1 / 2 + x * (q_2 / 3))) + rest * std::log1p(x / T);
}

double TabulatedHeatCapacity::energy(double T) const {
  std::size_t const k = interval(T);
  return eps_[k] + energy_in(k, T - T_[k]);
}

double TabulatedHeatCapacity::entropy(double T) const {
  std::size_t const k = interval(T);
  return S_[k] + entropy_in(k, T - T_[k]);
}

double TabulatedHeatCapacity::capacity_in(std::size_t k, double x) const {
  auto const [a, b, c, d] = cubic_[k];
  return a + x * (b + x * (c + x * d));
}

double TabulatedHeatCapacity::heat_capacity(double T) const {
  std::size_t const k = interval(T);
  return capacity_in(k, T - T_[k]);
}

double TabulatedHeatCapacity::heat_capacity_slope(double T) const {
  std::size_t const k = interval(T);
  auto const [a, b, c, d] = cubic_[k];
  double const x = T - T_[k];
  return b + x * (2 * c + x * 3 * d);
}

double TabulatedHeatCapacity::temperature(double eps, double T_guess) const {
  refuse_outside(eps, eps_.front(), eps_.back(), "internal energy over k_B");
  std::size_t const k = interval_of(eps_, eps);
  double low = T_[k], high = T_[k + 1], T = std::clamp(T_guess, low, high);
  constexpr int enough = 100; // bisections alone would need 60
  for (int step = 0; step < enough; ++step) {
    double const x = T - T_[k], error = eps_[k] + energy_in(k, x) - eps;
    (error > 0 ? high : low) = T;
    double const newton = T - error / capacity_in(k, x);
    bool const inside = newton > low && newton < high;
    double const next = inside ? newton : 0.5 * (low + high);
    // Newton's steps square the error: after one of 1e-9 nothing is left.
    bool const done = std::abs(next - T) <= (inside ? 1e-9 : 4e-16) * T;
    T = next;
    if (done)
      break;
  }
  return T;
}

TabulatedEntropy::TabulatedEntropy(std::vector<double> eps, std::vector<double> S)
    : table_eps_(eps), table_S_(S), eps_(std::move(eps)), S_(std::move(S)) {
  check_points(eps_, S_, "energy in the table of S(eps)", -std::numeric_limits<double>::infinity());
  for (double const s : S_)
    require(std::isfinite(s), "entropy in the table, in k_B", s, "must be finite");
  require(eps_.size() >= 5, "points of the table of S(eps)", eps_.size(), "must be at least 5");
  // The natural spline's curvature vanishes at both ends, where C would be infinite: the first and the last
  // interval only shape it and are left out.
  auto const spline = interpolate(gsl_interp_cspline, eps_, S_);
  for (std::size_t k = 0; k < eps_.size(); ++k) {
    slope_.push_back(gsl_interp_eval_deriv(spline.get(), eps_.data(), S_.data(), eps_[k], nullptr));
    curvature_.push_back(gsl_interp_eval_deriv2(spline.get(), eps_.data(), S_.data(), eps_[k], nullptr));
  }
  for (std::size_t k = 1; k + 1 < eps_.size(); ++k) {
    require(slope_[k] > 0, fmt::format("1/T at the energy {:.6g} of the table", eps_[k]), slope_[k],
            "must be > 0: the entropy must rise");
    require(curvature_[k] < 0, fmt::format("S'' at the energy {:.6g} of the table", eps_[k]), curvature_[k],
            "must be < 0: the heat capacity would not be positive");
  }
  for (auto* values : {&eps_, &S_, &slope_, &curvature_})
    values->erase(values->begin()), values->pop_back();
}

double TabulatedEntropy::second(Place p) const {
  return curvature_[p.k] + p.x * third(p);
}
double TabulatedEntropy::third(Place p) const {
  return (curvature_[p.k + 1] - curvature_[p.k]) / (eps_[p.k + 1] - eps_[p.k]);
}
double TabulatedEntropy::first(Place p) const {
  return slope_[p.k] + p.x * (curvature_[p.k] + 0.5 * p.x * third(p));
}

TabulatedEntropy::Place TabulatedEntropy::place(double T) const {
  refuse_outside(T, T_min(), T_max(), "temperature");
  auto const falling = std::upper_bound(slope_.begin() + 1, slope_.end() - 1, 1 / T, std::greater<>());
  auto const k = static_cast<std::size_t>(falling - slope_.begin()) - 1;
  // 1/T = s + c x + d x^2/2 with its falling root, written without cancellation.
  double const missing = slope_[k] - 1 / T, c = -curvature_[k], d = third({k, 0});
  double const root = std::sqrt(std::max(c * c - 2 * d * missing, 0.0));
  return {k, std::clamp(2 * missing / (c + root), 0.0, eps_[k + 1] - eps_[k])};
}

double TabulatedEntropy::energy(double T) const {
  Place const p = place(T);
  return eps_[p.k] + p.x;
}

double TabulatedEntropy::entropy(double T) const {
  Place const p = place(T);
  return S_[p.k] + p.x * (slope_[p.k] + p.x * (0.5 * curvature_[p.k] + p.x * third(p) / 6));
}

double TabulatedEntropy::temperature(double eps, double) const {
  refuse_outside(eps, eps_.front(), eps_.back(), "internal energy over k_B");
  std::size_t const k = interval_of(eps_, eps);
  return 1 / first({k, eps - eps_[k]});
}

double TabulatedEntropy::heat_capacity(double T) const {
  Place const p = place(T);
  return -first(p) * first(p) / second(p);
}

/// dC/dT = C dC/deps with C = -S'^2/S''.
double TabulatedEntropy::heat_capacity_slope(double T) const {
  Place const p = place(T);
  double const s_1 = first(p), s_2 = second(p), C = -s_1 * s_1 / s_2;
  double const by_energy = -2 * s_1 + s_1 * s_1 * third(p) / (s_2 * s_2);
  return C * by_energy;
}

} // namespace mesobridge::fitting
