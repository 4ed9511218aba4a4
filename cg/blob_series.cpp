#include "cg/blob_series.hpp"
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::cg {

MemoryTime memory_time(std::span<double const> values, std::size_t molecules, double interval) {
  constexpr double window_in_tau = 6;
  std::size_t const frames = values.size() / molecules;
  require(frames >= 16, "frames to find a correlation time in", frames, "at least 16 are needed");
  std::vector<double> total(frames / 2 + 1, 0.0), series(frames);
  for (std::size_t m = 0; m < molecules; ++m) {
    for (std::size_t t = 0; t < frames; ++t)
      series[t] = values[t * molecules + m];
    auto const covariance = autocovariance(series, frames / 2);
    for (std::size_t lag = 0; lag < total.size(); ++lag)
      total[lag] += covariance[lag];
  }
  double tau = 0.5;
  std::size_t lag = 1;
  for (; lag < total.size() && double(lag) < window_in_tau * tau; ++lag)
    tau += total[lag] / total[0];
  // The trapezoidal sum starts with 1/2; every covariance is low by the variance of a molecule's own mean.
  double const n = double(frames);
  tau = std::max(0.5, tau * (1 + 2 * double(lag) / n));
  double const samples = n * double(molecules);
  return {tau * interval, tau * interval * std::sqrt(2 * (2 * double(lag) + 1) / samples)};
}

std::vector<std::pair<std::size_t, std::size_t>> time_blocks(std::size_t frames, std::size_t count) {
  std::vector<std::pair<std::size_t, std::size_t>> blocks;
  for (std::size_t k = 0; k < count; ++k)
    blocks.emplace_back(k * frames / count, (k + 1) * frames / count);
  return blocks;
}

} // namespace mesobridge::cg
