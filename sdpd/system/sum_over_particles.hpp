#pragma once
#include "sdpd/system/system.hpp"
#include <numeric>

namespace mesobridge::sdpd {

/// Sum of f(i) over all particles, part by part: the same for any number of threads.
template <class F>
double sum_over_particles(System const& system, F const& f) {
  std::vector<double> parts((system.size() + range_length - 1) / range_length);
  for_each_range(system, [&](Range range) {
    double sum = 0;
    for (std::size_t i = range.begin; i < range.end; ++i)
      sum += f(i);
    parts[range.begin / range_length] = sum;
  });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

} // namespace mesobridge::sdpd
