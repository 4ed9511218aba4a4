#include "cg/estimate.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mesobridge::cg {
namespace {

double mean_of(std::span<double const> series) {
  return std::accumulate(series.begin(), series.end(), 0.0) / double(series.size());
}

double variance_of(std::span<double const> series) {
  double const mean = mean_of(series);
  double sum = 0;
  for (double x : series)
    sum += (x - mean) * (x - mean);
  return sum / double(series.size() - 1);
}

/// The rounding error of the mean: below it a series counts as constant.
bool is_constant(std::span<double const> series) {
  auto const [low, high] = std::minmax_element(series.begin(), series.end());
  return *high - *low <=
         4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(*low), std::abs(*high));
}

struct BlockLevel {
  double se;
  double se_se; ///< uncertainty of se itself, from the number of blocks
  std::size_t blocks;
};

BlockLevel block_level(std::span<double const> means) {
  double const blocks = double(means.size());
  double const se = std::sqrt(variance_of(means) / blocks);
  return {se, se / std::sqrt(2 * (blocks - 1)), means.size()};
}

/// Standard error at each block length 1, 2, 4 ... that leaves at least 8 blocks.
std::vector<BlockLevel> block_levels(std::span<double const> series) {
  std::vector<double> means(series.begin(), series.end());
  std::vector<BlockLevel> levels;
  while (means.size() >= 8) {
    levels.push_back(block_level(means));
    for (std::size_t k = 0; k < means.size() / 2; ++k)
      means[k] = (means[2 * k] + means[2 * k + 1]) / 2;
    means.resize(means.size() / 2);
  }
  return levels;
}

BlockLevel plateau(std::span<double const> series) {
  require(series.size() >= 16, "samples to average over blocks", series.size(), "at least 16 are needed");
  auto const levels = block_levels(series);
  double length = 1;
  for (auto const& level : levels) {
    double const ratio = levels[0].se > 0 ? level.se / levels[0].se : 1;
    if (length * length * length > 2 * double(series.size()) * std::pow(ratio, 4))
      return level;
    length *= 2;
  }
  return levels.back();
}

/// What pairs of lags say of the error of a mean.
struct PairedError {
  double se = 0;
  double variance_of_square = 0; ///< of an se^2 by so many lags, relative
};

/// Standard error of the mean by all pairs of lags until the first whose sum is not positive (cg/README.md,
/// Eq. (C50)): it follows a slow mode of small amplitude to where noise hides it.
PairedError error_by_positive_pairs(std::span<double const> series) {
  auto const gamma = autocovariance(series, series.size() / 2);
  double const n = double(series.size());
  double sum = -gamma[0];
  std::size_t lags = 0;
  for (; lags + 1 < gamma.size() && gamma[lags] + gamma[lags + 1] > 0; lags += 2)
    sum += 2 * (gamma[lags] + gamma[lags + 1]);
  double const unbiased = sum + (2 * double(lags) - 1) * sum / n;
  return {std::sqrt(std::max(unbiased, 0.0) / n), 4 * (double(lags) + 0.5) / n};
}

/// The same mean with a larger standard error, and as many fewer independent samples: one at least, as a
/// sample of its own scatters no less than a mean.
void enlarge(Estimate& estimate, double se) {
  estimate.n_eff = std::max(1.0, estimate.n_eff * std::pow(estimate.se / se, 2));
  estimate.se = se;
}

} // namespace

bool agrees(Estimate const& estimate, double value, double z) {
  return std::abs(estimate.mean - value) <= z * estimate.se;
}

double deviation(Estimate const& estimate, double value) {
  double const difference = estimate.mean - value;
  return difference == 0 ? 0 : difference / estimate.se;
}

Estimate estimate_by_autocorrelation(std::span<double const> series) {
  auto const memory = autocorrelation_time(series);
  double const n_eff = double(series.size()) / memory.inefficiency();
  return {mean_of(series), std::sqrt(memory.variance / n_eff), std::max(1.0, n_eff)};
}

Estimate estimate_by_blocking(std::span<double const> series) {
  auto const level = plateau(series);
  double const n_eff = level.se > 0 ? variance_of(series) / (level.se * level.se) : double(series.size());
  return {mean_of(series), level.se, n_eff};
}

Estimate estimate_mean(std::span<double const> series) {
  require(series.size() >= 16, "samples of a mean", series.size(), "at least 16 are needed");
  auto estimate = estimate_by_autocorrelation(series);
  auto const levels = block_levels(series);
  auto const surest =
      std::max_element(levels.begin(), levels.end(), [](BlockLevel const& a, BlockLevel const& b) {
        return a.se - 3 * a.se_se < b.se - 3 * b.se_se;
      });
  if (surest->se - 3 * surest->se_se > estimate.se)
    enlarge(estimate, surest->se);
  if (is_constant(series))
    return estimate;
  auto const pairs = error_by_positive_pairs(series);
  enlarge(estimate, std::max(estimate.se, pairs.se) * std::sqrt(1 + pairs.variance_of_square));
  return estimate;
}

Estimate estimate_variance(std::span<double const> series) {
  auto const memory = autocorrelation_time(series);
  if (is_constant(series))
    return {0, 0, double(series.size())};
  double const mean = mean_of(series);
  std::vector<double> squares(series.size());
  std::transform(series.begin(), series.end(), squares.begin(),
                 [&](double x) { return (x - mean) * (x - mean); });
  auto estimate = estimate_mean(squares);
  double const unbias = memory.variance / estimate.mean;
  return {estimate.mean * unbias, estimate.se * unbias, estimate.n_eff};
}

double covariance_of_means(std::span<double const> a, std::span<double const> b) {
  require(a.size() == b.size(), "samples of the second series", b.size(), "must be as many as of the first");
  // cov(a, b) = [var(a + b) - var(a - b)]/4 of means, with each series scaled to unit variance so that
  // neither hides the other. All three windows are chosen by the same rule.
  double const scale_a = std::sqrt(variance_of(a)), scale_b = std::sqrt(variance_of(b));
  if (is_constant(a) || is_constant(b))
    return 0;
  std::vector<double> sum(a.size()), difference(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum[k] = a[k] / scale_a + b[k] / scale_b;
    difference[k] = a[k] / scale_a - b[k] / scale_b;
  }
  double const se_sum = estimate_mean(sum).se, se_difference = estimate_mean(difference).se;
  double const covariance = scale_a * scale_b * (se_sum * se_sum - se_difference * se_difference) / 4;
  // Noise in the windows must not break |cov| <= se_a se_b, or the fit's weight matrix would not be positive
  // definite.
  double const bound = 0.9999 * estimate_mean(a).se * estimate_mean(b).se;
  return std::abs(covariance) <= bound ? covariance : std::copysign(bound, covariance);
}

} // namespace mesobridge::cg
