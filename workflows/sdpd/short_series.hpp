#pragma once
#include "cg/estimate.hpp"
#include <cmath>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::workflows {

/// The mean of a series, of one value at least. Too few values to know their memory are taken as independent;
/// the error of a single one is 0.
inline cg::Estimate mean_of_series(std::span<double const> values) {
  constexpr std::size_t enough = 16;
  if (values.size() >= enough)
    return cg::estimate_mean(values);
  double const mean = gsl_stats_mean(values.data(), 1, values.size()), n = static_cast<double>(values.size());
  return {mean, n > 1 ? gsl_stats_sd(values.data(), 1, values.size()) / std::sqrt(n) : 0, n};
}

} // namespace mesobridge::workflows
