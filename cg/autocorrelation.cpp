#include "cg/estimate.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <numeric>

namespace mesobridge::cg {
namespace {

void require_finite(std::span<double const> series) {
  for (std::size_t k = 0; k < series.size(); ++k)
    require(std::isfinite(series[k]), "sample", series[k], "must be finite");
}

/// The first lag at which truncating the sum costs less than the noise of its next term.
std::size_t automatic_window(std::vector<double> const& gamma, double n) {
  constexpr double stiffness = 1.5;
  double tau_int = 0.5;
  for (std::size_t lag = 1; lag < gamma.size(); ++lag) {
    tau_int += gamma[lag] / gamma[0];
    double const w = double(lag);
    // Without (or with negative) memory the decay time has no value: any tiny one ends the sum here.
    double const tau = tau_int > 0.5 ? stiffness / std::log((2 * tau_int + 1) / (2 * tau_int - 1)) : 1e-10;
    if (std::exp(-w / tau) < tau / std::sqrt(w * n))
      return lag;
  }
  return gamma.size() - 1;
}

} // namespace

std::vector<double> autocovariance(std::span<double const> series, std::size_t max_lag) {
  std::size_t const n = series.size();
  require(n >= 2, "samples", n, "at least 2 are needed for a correlation");
  require(max_lag < n, "largest lag", max_lag, "must be less than the number of samples");
  require_finite(series);
  double const mean = std::accumulate(series.begin(), series.end(), 0.0) / double(n);
  // Zeros behind the series keep the circular correlation of the FFT from wrapping round.
  std::size_t const padded = std::bit_ceil(n + max_lag + 1);
  std::vector<double> work(padded, 0.0);
  std::transform(series.begin(), series.end(), work.begin(), [&](double x) { return x - mean; });
  gsl_fft_real_radix2_transform(work.data(), 1, padded);
  work[0] *= work[0];
  work[padded / 2] *= work[padded / 2];
  for (std::size_t k = 1; k < padded / 2; ++k) {
    work[k] = work[k] * work[k] + work[padded - k] * work[padded - k];
    work[padded - k] = 0;
  }
  gsl_fft_halfcomplex_radix2_inverse(work.data(), 1, padded);
  std::vector<double> gamma(max_lag + 1);
  for (std::size_t lag = 0; lag <= max_lag; ++lag)
    gamma[lag] = work[lag] / double(n - lag);
  return gamma;
}

Autocorrelation autocorrelation_time(std::span<double const> series) {
  require(series.size() >= 4, "samples", series.size(), "at least 4 are needed for a correlation time");
  double const n = double(series.size());
  auto const gamma = autocovariance(series, series.size() / 2);
  auto const [low, high] = std::minmax_element(series.begin(), series.end());
  double const round_off = 1e-15 * std::max(std::abs(*low), std::abs(*high));
  if (*high - *low <= round_off)
    return {}; // a constant: no variance and no memory

  std::size_t const window = automatic_window(gamma, n);
  double sum = gamma[0]; // n times the squared standard error of the mean
  for (std::size_t lag = 1; lag <= window; ++lag)
    sum += 2 * gamma[lag];
  // Strongly alternating series can sum to nothing or less; the error of independent samples is then a safe
  // bound.
  if (sum <= 0)
    return {gamma[0] * n / (n - 1), 0.5, 0, window};
  double const bias = sum / n; // every Gamma(t) is low by the variance of the mean
  double const variance = gamma[0] + bias;
  double const tau = (sum + double(2 * window + 1) * bias) / (2 * variance);
  double const spread = std::max(double(window) + 0.5 - tau, 0.5);
  return {variance, tau, tau * 2 * std::sqrt(spread / n), window};
}

} // namespace mesobridge::cg
