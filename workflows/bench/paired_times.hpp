#pragma once
#include <cmath>
#include <numeric>
#include <vector>

namespace mesobridge::workflows {

/// What steps cost, microseconds per particle and step, and beside the first of what is timed with them, one
/// number for each repeat.
struct PairedTimes {
  std::vector<double> cost, ratio;
};

inline double mean_of_repeats(std::vector<double> const& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Of their mean; 0 for one repeat.
inline double standard_error_of_repeats(std::vector<double> const& values) {
  double const n = static_cast<double>(values.size()), middle = mean_of_repeats(values);
  double square = 0;
  for (double const value : values)
    square += (value - middle) * (value - middle);
  return n > 1 ? std::sqrt(square / (n * (n - 1))) : 0;
}

} // namespace mesobridge::workflows
