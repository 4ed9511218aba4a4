#pragma once
#include "sdpd/system/system.hpp"
#include <functional>
#include <numeric>

namespace mesobridge::sdpd {

/// f(i) of all particles put together by `both`, from a start on, part by part: the same for any number of
/// threads.
template <class F, class Both>
double fold_over_particles(System const& system, F const& f, double start, Both const& both) {
  std::vector<double> parts((system.size() + range_length - 1) / range_length);
  for_each_range(system, [&](Range range) {
    double of_part = start;
    for (std::size_t i = range.begin; i < range.end; ++i)
      of_part = both(of_part, f(i));
    parts[range.begin / range_length] = of_part;
  });
  return std::accumulate(parts.begin(), parts.end(), start, both);
}

/// Sum of f(i) over all particles.
template <class F>
double sum_over_particles(System const& system, F const& f) {
  return fold_over_particles(system, f, 0, std::plus<double>());
}

} // namespace mesobridge::sdpd
