#include "cg/distribution_error.hpp"
#include <cmath>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::cg {

Bins bins_around(std::span<double const> values, double unit) {
  if (values.empty())
    return {};
  double const mean = gsl_stats_mean(values.data(), 1, values.size()),
               sd = gsl_stats_sd(values.data(), 1, values.size());
  constexpr double reach = 8;
  return {.lower = unit * (mean - reach * sd), .upper = unit * (mean + reach * sd)};
}

double distribution_error(std::span<double const> found, std::span<double const> reference) {
  double square = 0, norm = 0;
  for (std::size_t b = 0; b < reference.size(); ++b) {
    square += (found[b] - reference[b]) * (found[b] - reference[b]);
    norm += reference[b] * reference[b];
  }
  return std::sqrt(square / norm);
}

double distribution_noise(std::span<double const> first_half, std::span<double const> second_half,
                          std::span<double const> reference) {
  double square = 0, norm = 0;
  for (std::size_t b = 0; b < reference.size(); ++b) {
    double const half = 0.5 * (first_half[b] - second_half[b]);
    square += half * half;
    norm += reference[b] * reference[b];
  }
  return std::sqrt(square / norm);
}

} // namespace mesobridge::cg
