#include "sdpd/observe/energy_walk.hpp"
#include <cmath>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::sdpd {
namespace {

/// Squared increments over `lag` samples, freed from the mean increment.
std::vector<double> squared_increments(std::span<double const> energies, std::size_t lag) {
  std::vector<double> gain;
  for (std::size_t k = 0; k + lag < energies.size(); ++k)
    gain.push_back(energies[k + lag] - energies[k]);
  double const mean = gsl_stats_mean(gain.data(), 1, gain.size());
  for (double& g : gain)
    g = (g - mean) * (g - mean);
  return gain;
}

double interval_of(std::span<double const> times) {
  return (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

std::size_t lag_in_samples(std::span<double const> times, double lag) {
  return static_cast<std::size_t>(std::max(1.0, std::round(lag / interval_of(times))));
}

} // namespace

bool enough_for_energy_walk(std::span<double const> times, double lag) {
  return times.size() >= 2 && times.size() > 32 * lag_in_samples(times, lag);
}

Drift drift_from_energy_walk(std::span<double const> times, std::span<double const> energies, double lag,
                             double boltzmann, double T) {
  std::size_t const n = times.size();
  require(n >= 2 && n == energies.size(), "samples for an energy walk", n,
          "must be many, times and energies alike");
  double const interval = interval_of(times);
  auto const step = lag_in_samples(times, lag);
  require(enough_for_energy_walk(times, lag), "samples for an energy walk", n,
          fmt::format("must be more than 32 lags of {} samples", step));
  auto const once = squared_increments(energies, step), twice = squared_increments(energies, 2 * step);
  // Overlapping increments use all samples; blocks of four lags and more are nearly independent.
  std::size_t const blocks = std::min<std::size_t>(32, twice.size() / (4 * step));
  double const per_time =
      1 / (2 * boltzmann * T * std::abs(energies[0]) * interval * static_cast<double>(step));
  std::vector<double> rates;
  for (std::size_t b = 0; b < blocks; ++b) {
    std::size_t const begin = b * twice.size() / blocks, end = (b + 1) * twice.size() / blocks;
    rates.push_back(per_time * (gsl_stats_mean(&twice[begin], 1, end - begin) -
                                gsl_stats_mean(&once[begin], 1, end - begin)));
  }
  return {gsl_stats_mean(rates.data(), 1, blocks),
          gsl_stats_sd(rates.data(), 1, blocks) / std::sqrt(static_cast<double>(blocks))};
}

} // namespace mesobridge::sdpd
