#include "cg/diffusion.hpp"
#include "cg/decay_lag.hpp"
#include "cg/jackknife.hpp"
#include "cg/own_motion.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mesobridge::cg {
namespace {

constexpr double least_resolved = 0.8; // of the correlation at the first lag, for its integral
constexpr double window_in_decays = 8;

/// <x(s+t) x(s)> of every lag up to the last, without a mean taken off.
std::vector<double> products(std::vector<double> const& x, std::size_t last) {
  double const n = double(x.size()), mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  auto result = autocovariance(x, last);
  double head = 0, tail = 0; // sums of x - mean over the first and the last `lag` frames
  for (std::size_t lag = 0; lag <= last; ++lag) {
    result[lag] += mean * mean - mean * (head + tail) / (n - double(lag));
    if (lag < last)
      head += x[lag] - mean, tail += x[x.size() - 1 - lag] - mean;
  }
  return result;
}

/// <(x(s+t) - x(s))^2> of every lag up to the last.
std::vector<double> squared_changes(std::vector<double> const& x, std::size_t last) {
  double const n = double(x.size()), mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  auto result = autocovariance(x, last);
  double both = 0; // squares of the frames that can be the earlier, and of those that can be the later one
  for (double const value : x)
    both += 2 * (value - mean) * (value - mean);
  for (std::size_t lag = 0; lag <= last; ++lag) {
    result[lag] = std::max(0.0, both / (n - double(lag)) - 2 * result[lag]);
    double const late = x[lag] - mean, early = x[x.size() - 1 - lag] - mean;
    both -= late * late + early * early;
  }
  return result;
}

void check(BlobSeries const& series, DiffusionSettings const& settings) {
  require(series.frames() >= 16, "frames", series.frames(), "at least 16 are needed for diffusion");
  require(series.molecules >= 4, "molecules", series.molecules, "at least 4 are needed for standard errors");
  require(settings.groups >= 4, "groups of molecules", settings.groups, "must be at least 4");
  require_equal_intervals(series);
  double const interval = series.interval(), run = series.times.back() - series.times.front();
  require(settings.longest == 0 || (settings.longest >= 4 * interval && settings.longest <= run),
          "longest lag", settings.longest,
          fmt::format("must be {:g} (4 frames) ... {:g} (the run)", 4 * interval, run));
  require(settings.viscosity >= 0 && std::isfinite(settings.viscosity), "viscosity", settings.viscosity,
          "must be >= 0 and finite");
  require(settings.viscosity_se >= 0 && std::isfinite(settings.viscosity_se), "error of the viscosity",
          settings.viscosity_se, "must be >= 0 and finite");
}

/// Sums of one group: displacements of every lag, then velocities of every lag, then the number of molecules.
std::vector<Sums> sums_of_groups(BlobSeries const& series, std::vector<Vec3> const& ways,
                                 std::vector<Vec3> const& velocities, std::size_t last, std::size_t count) {
  std::size_t const N = series.molecules, n = series.frames(), lags = last + 1;
  std::vector<Sums> groups(count, Sums(2 * lags + 1, 0.0));
  std::vector<double> x(n), v(n);
  for (std::size_t m = 0; m < N; ++m) {
    auto& sums = groups[m * count / N];
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t k = 0; k < n; ++k)
        x[k] = component(ways[k * N + m], axis), v[k] = component(velocities[k * N + m], axis);
      auto const changes = squared_changes(x, last), correlation = products(v, last);
      for (std::size_t lag = 0; lag < lags; ++lag)
        sums[lag] += changes[lag], sums[lags + lag] += correlation[lag];
    }
    sums.back() += 1;
  }
  return groups;
}

/// Least squares of Delta^2/6 over the lags from `first` to `last`.
double slope(Sums const& sums, std::size_t first, std::size_t last, double interval) {
  double const n = double(last - first + 1), middle = 0.5 * double(first + last);
  double up = 0, down = 0;
  for (std::size_t lag = first; lag <= last; ++lag)
    up += (double(lag) - middle) * sums[lag], down += (double(lag) - middle) * (double(lag) - middle);
  return n > 1 ? up / down / (6 * sums.back() * interval) : 0;
}

/// When the velocity's correlation has fallen to 1/e, in frames.
double velocity_decay_lag(Sums const& sums, std::size_t lags) {
  return decay_lag(lags, [&](std::size_t lag) { return sums[lags + lag]; });
}

/// Standard error of D over D, from when all molecules move (cg/README.md, Eq. (C52)); 0 where the run is too
/// short to tell.
double error_in_time(BlobSeries const& series, std::vector<Vec3> const& ways, std::size_t last) {
  std::size_t const N = series.molecules;
  std::vector<double> growth; // of the displacements over the second half of the lags, by when they begin
  for (std::size_t s = 0; s + last < series.frames(); ++s) {
    double sum = 0;
    for (std::size_t m = 0; m < N; ++m) {
      auto const& start = ways[s * N + m];
      sum += norm2(ways[(s + last) * N + m] - start) - norm2(ways[(s + last / 2) * N + m] - start);
    }
    growth.push_back(sum);
  }
  if (growth.size() < 16)
    return 0;
  auto const mean = estimate_mean(growth);
  return mean.mean > 0 ? mean.se / mean.mean : 0;
}

} // namespace

Diffusion diffusion(BlobSeries const& series, DiffusionSettings const& settings) {
  check(series, settings);
  auto const ways = own_ways(series), velocities = own_velocities(series);
  require_known_ways(series, ways);
  require_moving(velocities);
  double const interval = series.interval();
  std::size_t const last = settings.longest > 0 ? std::size_t(std::lround(settings.longest / interval))
                                                : std::max<std::size_t>(4, series.frames() / 10),
                    lags = last + 1;
  auto const groups =
      sums_of_groups(series, ways, velocities, last, std::min(settings.groups, series.molecules));
  Sums all(2 * lags + 1, 0.0);
  for (auto const& group : groups)
    std::transform(group.begin(), group.end(), all.begin(), all.begin(), std::plus<>());
  double const decay = velocity_decay_lag(all, lags);
  auto const window = std::size_t(std::ceil(window_in_decays * decay));
  bool const resolved = all[lags + 1] > least_resolved * all[lags],
             decayed = decay < 0.8 * double(last);                // so that groups fall to it, too
  double const N = double(series.molecules), alone = N / (N - 1); // all together have taken one's share
  auto const estimates = jackknife(groups, [&](Sums const& sums) {
    std::vector<double> numbers{
        alone * slope(sums, last / 2, last, interval), alone * slope(sums, last / 4, last / 2, interval),
        alone * series.mass * sums[lags] / (3 * sums.back()), velocity_decay_lag(sums, lags) * interval};
    double integral = 0.5 * sums[lags];
    for (std::size_t lag = 1; lag <= std::min(window, last); ++lag)
      integral += sums[lags + lag];
    numbers.push_back(alone * interval * integral / (3 * sums.back()));
    for (std::size_t lag = 0; lag < lags; ++lag)
      numbers.push_back(alone * sums[lag] / sums.back());
    for (std::size_t lag = 0; lag < lags; ++lag)
      numbers.push_back(sums[lags + lag] / sums[lags]);
    return numbers;
  });
  Diffusion found{.lag = {},
                  .displacement = {},
                  .velocity = {},
                  .D = estimates[0],
                  .D_earlier = estimates[1],
                  .temperature = estimates[2],
                  .decay = {},
                  .D_velocity = {},
                  .D_infinite = {}};
  found.D.se = std::max(found.D.se, found.D.mean * error_in_time(series, ways, last));
  for (std::size_t lag = 0; lag < lags; ++lag) {
    found.lag.push_back(double(lag) * interval);
    found.displacement.push_back(estimates[5 + lag]);
    found.velocity.push_back(estimates[5 + lags + lag]);
  }
  if (resolved && decayed)
    found.decay = estimates[3];
  if (resolved && window <= last)
    found.D_velocity = estimates[4];
  if (settings.viscosity > 0) {
    constexpr double of_cube = 2.837297;
    double const kT = settings.temperature > 0 ? settings.temperature : found.temperature.mean,
                 edge = std::cbrt(series.boxes.front().volume());
    double const share = of_cube * kT / (6 * std::numbers::pi * settings.viscosity * edge);
    found.D_infinite = found.D;
    found.D_infinite->mean += share;
    found.D_infinite->se = std::hypot(found.D.se, share * settings.viscosity_se / settings.viscosity);
  }
  return found;
}

} // namespace mesobridge::cg
