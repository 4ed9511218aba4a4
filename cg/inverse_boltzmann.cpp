#include "cg/inverse_boltzmann.hpp"
#include "cg/cubic_splines.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_multifit.h>
#include <memory>
#include <numbers>

namespace mesobridge::cg {
namespace {

/// Of the structure factor, in steps that only have to lead the right way.
constexpr double least_structure = 0.05;

template <auto Free>
struct Freed {
  void operator()(auto* p) const { Free(p); }
};
template <class T, auto Free>
using Owned = std::unique_ptr<T, Freed<Free>>;

/// Values y with weights w at the middles of the bins `first` ... `last`, smoothed by the cubic spline of
/// least squares.
std::vector<double> smoothed(std::vector<double> const& y, std::vector<double> const& w, double width,
                             double knots) {
  std::size_t const n = y.size(), most = n / 2 + 1,
                    breaks = std::clamp<std::size_t>(std::size_t(std::lround(double(n) * width / knots)) + 1,
                                                     2, most);
  CubicSplines const spline(0, double(n), breaks - 1);
  std::size_t const order = spline.size();
  Owned<gsl_matrix, gsl_matrix_free> const X(gsl_matrix_alloc(n, order)),
      covariance(gsl_matrix_alloc(order, order));
  Owned<gsl_vector, gsl_vector_free> const values(gsl_vector_alloc(n)), weights(gsl_vector_alloc(n)),
      coefficients(gsl_vector_alloc(order));
  for (std::size_t k = 0; k < n; ++k) {
    auto const basis = spline(double(k) + 0.5);
    for (std::size_t j = 0; j < order; ++j)
      gsl_matrix_set(X.get(), k, j, basis[j]);
    gsl_vector_set(values.get(), k, y[k]), gsl_vector_set(weights.get(), k, w[k]);
  }
  Owned<gsl_multifit_linear_workspace, gsl_multifit_linear_free> const fit(
      gsl_multifit_linear_alloc(n, order));
  double chi_squared = 0;
  gsl_multifit_wlinear(X.get(), weights.get(), values.get(), coefficients.get(), covariance.get(),
                       &chi_squared, fit.get());
  std::vector<double> result(n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < order; ++j)
      result[k] += gsl_matrix_get(X.get(), k, j) * gsl_vector_get(coefficients.get(), j);
  return result;
}

/// The bins in which both say something, from the outside in: [first, last).
struct Said {
  std::size_t first, last;
};

Said said_by(RadialBins const& target, InversionSettings const& settings) {
  require(settings.kT > 0, "kT", settings.kT, "must be > 0");
  require(settings.share > 0 && settings.share <= 1, "share", settings.share, "must be in (0, 1]");
  require(settings.knots > 0, "knots", settings.knots, "must be > 0");
  double const end = target.width * double(target.g.size());
  require(settings.cutoff > 0 && settings.cutoff <= end * (1 + 1e-9), "cutoff", settings.cutoff,
          fmt::format("must be above 0, and within {:g}, to which g(r) is known", end));
  auto const last = std::size_t(std::lround(settings.cutoff / target.width));
  auto const weight = [&](std::size_t k) { // of the pairs that a bin holds
    double const r = (double(k) + 0.5) * target.width;
    return target.g[k] * r * r;
  };
  double most = 0;
  for (std::size_t k = 0; k < last; ++k)
    most = std::max(most, weight(k));
  std::size_t first = last;
  while (first > 0 && target.g[first - 1] > settings.least_g &&
         weight(first - 1) > settings.least_pairs * most)
    --first;
  require(last - first >= 8, "bins of g(r) within the cut-off that hold pairs", last - first,
          "at least 8 are needed");
  return {first, last};
}

/// With h falling to zero between r_c and 2 r_c: noise at large distances would spoil the long waves.
RadialBins tapered(RadialBins bins, double r_c) {
  for (std::size_t k = 0; k < bins.g.size(); ++k) {
    double const beyond = std::clamp((double(k) + 0.5) * bins.width / r_c - 1, 0.0, 1.0),
                 part = std::cos(0.5 * std::numbers::pi * beyond);
    bins.g[k] = 1 + part * part * (bins.g[k] - 1);
  }
  return bins;
}

/// What c and h of the target and of now say of the change of u/kT beside ln(g/g_target).
std::vector<double> beyond_pairs(RadialBins const& target, RadialBins const& now,
                                 InversionSettings const& settings) {
  std::vector<double> change(now.g.size());
  if (settings.density == 0)
    return change;
  auto const c_of = [&](RadialBins const& bins) {
    return direct_correlation(tapered(bins, settings.cutoff), settings.density, least_structure);
  };
  auto const c_target = c_of(target), c_now = c_of(now);
  for (std::size_t k = 0; k < change.size(); ++k)
    change[k] = target.g[k] - now.g[k] - c_target[k] + c_now[k];
  return change;
}

/// Zero at the cut-off, and a + b r^2 in the core, with value and slope of the first bins outside.
PairPotential finished(PairPotential potential, std::size_t first) {
  auto& u = potential.u;
  std::size_t const n = u.size();
  double const end = u[n - 1] + 0.5 * (u[n - 1] - u[n - 2]);
  for (double& value : u)
    value -= end;
  double const r = potential.r(first), slope = std::min(0.0, (u[first + 1] - u[first]) / potential.width);
  for (std::size_t k = 0; k < first; ++k)
    u[k] = u[first] + 0.5 * slope / r * (potential.r(k) * potential.r(k) - r * r);
  return potential;
}

} // namespace

PairPotential boltzmann_potential(RadialBins const& target, InversionSettings const& settings) {
  auto const [first, last] = said_by(target, settings);
  PairPotential potential{target.width, std::vector<double>(last)};
  std::vector<double> raw, weights;
  for (std::size_t k = first; k < last; ++k) {
    raw.push_back(-settings.kT * std::log(target.g[k]));
    weights.push_back(target.g[k] * potential.r(k) * potential.r(k));
  }
  std::ranges::copy(smoothed(raw, weights, target.width, settings.knots),
                    potential.u.begin() + std::ptrdiff_t(first));
  return finished(std::move(potential), first);
}

PairPotential inverted(PairPotential const& before, RadialBins const& target, RadialBins const& now,
                       InversionSettings const& settings) {
  auto const [first, last] = said_by(target, settings);
  require(before.u.size() == last && now.g.size() == target.g.size() && now.width == target.width,
          "bins of g(r)", now.g.size(), "must be those of the target");
  auto const beyond = beyond_pairs(target, now, settings);
  std::vector<double> change, weights;
  for (std::size_t k = first; k < last; ++k) {
    double const shown = std::max(now.g[k], settings.least_g), r = before.r(k);
    change.push_back(settings.share * settings.kT * (std::log(shown / target.g[k]) + beyond[k]));
    weights.push_back(std::min(shown, target.g[k]) * r * r);
  }
  auto const smooth = smoothed(change, weights, target.width, settings.knots);
  auto after = before;
  for (std::size_t k = first; k < last; ++k)
    after.u[k] += smooth[k - first];
  return finished(std::move(after), first);
}

namespace {

/// The pressure that A (1 - r/r_c) adds, over A.
double pressure_of_ramp(PairPotential const& potential, RadialBins const& now, double density) {
  double moment = 0;
  for (std::size_t k = 0; k < potential.u.size(); ++k)
    moment += std::pow(potential.r(k), 3) * now.g[k] * potential.width;
  return 2 * std::numbers::pi / 3 * density * density * moment / potential.cutoff();
}

} // namespace

double pressure_change(PairPotential const& before, PairPotential const& after, RadialBins const& now,
                       double density) {
  std::size_t const n = before.u.size();
  auto const change = [&](std::size_t k) { // odd about the cut-off, where it is zero
    return k < n ? after.u[k] - before.u[k] : before.u[n - 1] - after.u[n - 1];
  };
  double virial = 0;
  for (std::size_t k = 0; k < n; ++k)
    virial += std::pow(before.r(k), 3) * now.g[k] * (change(k + 1) - change(k == 0 ? 0 : k - 1)) / 2;
  return -2 * std::numbers::pi / 3 * density * density * virial;
}

PairPotential with_less_pressure(PairPotential const& before, RadialBins const& now, double density,
                                 double excess, double most) {
  double const A = std::clamp(-excess / pressure_of_ramp(before, now, density), -most, most);
  auto after = before;
  for (std::size_t k = 0; k < after.u.size(); ++k)
    after.u[k] += A * (1 - after.r(k) / before.cutoff());
  return after;
}

PairPotential inverted_at_pressure(PairPotential const& before, RadialBins const& target,
                                   RadialBins const& now, InversionSettings const& settings, double density,
                                   double excess) {
  auto const after = inverted(before, target, now, settings);
  double const change = pressure_change(before, after, now, density),
               undone = std::abs(change / pressure_of_ramp(before, now, density));
  // Far away by large steps, a quarter of the way each; near by small ones, for noise.
  double const wanted = std::abs(excess / pressure_of_ramp(before, now, density));
  return with_less_pressure(after, now, density, excess + change,
                            undone + std::max(0.3 * settings.kT, 0.25 * wanted));
}

std::vector<double> direct_correlation(RadialBins const& bins, double density, double least_S) {
  std::size_t const n = bins.g.size();
  double const pi = std::numbers::pi, R = bins.width * double(n);
  std::vector<double> r_c(n);
  for (std::size_t j = 1; j <= n; ++j) {
    double const k = pi * double(j) / R;
    double h = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double const r = (double(i) + 0.5) * bins.width;
      h += r * (bins.g[i] - 1) * std::sin(k * r);
    }
    h *= 4 * pi * bins.width / k;
    double const S = std::max(1 + density * h, least_S);
    double const part = (j == n ? 0.5 : 1) * k * h / S * (pi / R) / (2 * pi * pi);
    for (std::size_t i = 0; i < n; ++i)
      r_c[i] += part * std::sin(k * (double(i) + 0.5) * bins.width);
  }
  for (std::size_t i = 0; i < n; ++i)
    r_c[i] /= (double(i) + 0.5) * bins.width;
  return r_c;
}

double g_difference(RadialBins const& target, RadialBins const& now) {
  double apart = 0, whole = 0;
  for (std::size_t k = 0; k < std::min(target.g.size(), now.g.size()); ++k) {
    double const r = (double(k) + 0.5) * target.width, d = now.g[k] - target.g[k];
    apart += d * d * r * r, whole += target.g[k] * target.g[k] * r * r;
  }
  return apart / whole;
}

} // namespace mesobridge::cg
