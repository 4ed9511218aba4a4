#include "cg/friction_table.hpp"
#include "cg/cubic_splines.hpp"
#include "cg/nonnegative_squares.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::cg {
namespace {

/// Of the change of neighbouring coefficients' slopes, per pair: decides where no pair does.
constexpr double stiffness = 1e-4;
constexpr std::size_t points_of_a_bin = 5;

/// Cubic B-splines over [first, cutoff], without those that do not vanish, with their slope, at the cut-off;
/// the first two are one, which has no slope at the first point.
class Splines {
 public:
  Splines(double first, double cutoff, double knots)
      : all_(first, cutoff, std::max<std::size_t>(2, std::size_t(std::lround((cutoff - first) / knots)))) {}
  std::size_t size() const { return all_.size() - 3; }
  /// All at r; before the first point as there.
  std::vector<double> operator()(double r) const {
    auto const all = all_(r);
    std::vector<double> values(all.begin() + 1, all.begin() + 1 + std::ptrdiff_t(size()));
    values[0] += all[0];
    return values;
  }

 private:
  CubicSplines all_;
};

/// The least squares of one of the two frictions: the splines' means over each bin's pairs.
struct Normal {
  std::vector<double> A, b, c; ///< c: their sums over the pairs
};

Normal normal_of(MeasuredFriction const& measured, std::vector<double> const& friction,
                 Splines const& splines, double cutoff) {
  std::size_t const n = splines.size(), fine = measured.fine;
  Normal normal{std::vector<double>(n * n), std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t bin = 0; bin < friction.size() && double(bin) * measured.width < cutoff; ++bin) {
    double pairs = 0;
    std::vector<double> mean(n);
    for (std::size_t k = bin * fine; k < (bin + 1) * fine; ++k) {
      double const r = (double(k) + 0.5) * measured.width / double(fine), count = measured.count[k];
      pairs += count;
      if (auto const at = splines(r); r < cutoff)
        for (std::size_t j = 0; j < n; ++j)
          mean[j] += count * at[j];
    }
    if (pairs == 0)
      continue;
    for (std::size_t i = 0; i < n; ++i) {
      normal.c[i] += mean[i];
      normal.b[i] += mean[i] * friction[bin];
      for (std::size_t j = 0; j < n; ++j)
        normal.A[i * n + j] += mean[i] * mean[j] / pairs;
    }
  }
  return normal;
}

/// Adds what coefficients that change their slope cost.
void stiffen(std::vector<double>& A, std::size_t first, std::size_t n, std::size_t order, double weight) {
  for (std::size_t k = 0; k + 2 < n; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        A[(first + k + i) * order + first + k + j] += weight * (i == 1 ? -2 : 1) * (j == 1 ? -2 : 1);
}

std::vector<double> coefficients(MeasuredFriction const& measured, Splines const& splines, double cutoff) {
  auto const along = normal_of(measured, measured.par, splines, cutoff),
             across = normal_of(measured, measured.perp, splines, cutoff);
  std::size_t const n = splines.size(), all = 2 * n;
  std::vector<double> A(all * all), b(all), c(all);
  double pairs = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double const share = 2 / (3 * measured.molecules); // a pair is one of each of its two molecules
    b[i] = along.b[i], b[n + i] = 2 * across.b[i];
    c[i] = share * along.c[i], c[n + i] = 2 * share * across.c[i];
    pairs += along.c[i];
    for (std::size_t j = 0; j < n; ++j)
      A[i * all + j] = along.A[i * n + j], A[(n + i) * all + n + j] = 2 * across.A[i * n + j];
  }
  stiffen(A, 0, n, all, stiffness * pairs), stiffen(A, n, n, all, stiffness * pairs);
  return nonnegative_squares(A, b, c, measured.self);
}

/// Linear between the points.
double value_at(std::vector<double> const& x, std::vector<double> const& y, double at) {
  if (at <= x.front())
    return y.front();
  if (at >= x.back())
    return 0;
  auto const after = std::size_t(std::ranges::upper_bound(x, at) - x.begin());
  return y[after - 1] + (at - x[after - 1]) / (x[after] - x[after - 1]) * (y[after] - y[after - 1]);
}

double first_distance(MeasuredFriction const& measured) {
  auto const first = std::ranges::find_if(measured.count, [](double n) { return n > 0; });
  return double(first - measured.count.begin()) * measured.width / double(measured.fine);
}

} // namespace

double MeasuredFriction::pairs(std::size_t bin) const {
  auto const first = count.begin() + std::ptrdiff_t(bin * fine);
  return std::accumulate(first, first + std::ptrdiff_t(fine), 0.0);
}

double MeasuredFriction::sum(double cutoff) const {
  double result = 0;
  for (std::size_t bin = 0; bin < par.size() && (double(bin) + 0.5) * width < cutoff; ++bin)
    result += 2 * pairs(bin) * (par[bin] + 2 * perp[bin]) / 3;
  return result / molecules;
}

double FrictionTable::par_at(double at) const {
  return value_at(r, par, at);
}

double FrictionTable::perp_at(double at) const {
  return value_at(r, perp, at);
}

FrictionTable friction_table(MeasuredFriction const& measured, double cutoff, double knots) {
  require(measured.self > 0, "friction of a molecule", measured.self, "must be > 0");
  require(knots > 0, "distance of knots", knots, "must be > 0");
  double const first = first_distance(measured), bins = (cutoff - first) / measured.width;
  require(bins >= 4, "bins of r between the nearest pair and the cut-off", bins, "must be at least 4");
  Splines const splines(first, cutoff, knots);
  std::size_t const n = splines.size();
  auto const x = coefficients(measured, splines, cutoff);
  FrictionTable table;
  auto const points = std::size_t(std::ceil(bins * points_of_a_bin));
  for (std::size_t k = 0; k <= points; ++k) {
    double const r = k == points ? cutoff : first + (cutoff - first) * double(k) / double(points);
    auto const at = splines(r);
    double par = 0, perp = 0;
    for (std::size_t j = 0; j < n && k < points; ++j)
      par += x[j] * at[j], perp += x[n + j] * at[j];
    table.r.push_back(r), table.par.push_back(par), table.perp.push_back(perp);
  }
  double const factor = measured.self / friction_sum(table, measured); // lines are not quite the splines
  for (std::size_t k = 0; k <= points; ++k)
    table.par[k] *= factor, table.perp[k] *= factor;
  return table;
}

double friction_sum(FrictionTable const& table, MeasuredFriction const& measured) {
  double sum = 0;
  for (std::size_t k = 0; k < measured.count.size(); ++k) {
    double const r = (double(k) + 0.5) * measured.width / double(measured.fine);
    sum += 2 * measured.count[k] * (table.par_at(r) + 2 * table.perp_at(r)) / 3;
  }
  return sum / measured.molecules;
}

} // namespace mesobridge::cg
