#pragma once
#include "workflows/command.hpp"
#include <cmath>
#include <fmt/format.h>
#include <numeric>

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

/// us_per_particle_step, ratio, ratio_se.
inline void put_times(Json& row, PairedTimes const& times) {
  row["us_per_particle_step"] = mean_of_repeats(times.cost);
  row["ratio"] = mean_of_repeats(times.ratio);
  row["ratio_se"] = standard_error_of_repeats(times.ratio);
}

/// The head of a table of such rows by name, and one of its lines, without an end.
inline std::string times_head(std::string_view what, std::string_view beside) {
  return fmt::format("{:<16} {:>20} {:>24} {:>12}", what, "us/(particle step)", beside, "neighbours");
}
inline std::string times_line(Json const& row, std::string const& what) {
  return fmt::format("{:<16} {:>20.3f} {:>14.3f} +- {:.3f} {:>12.1f}", row[what].get<std::string>(),
                     row["us_per_particle_step"].get<double>(), row["ratio"].get<double>(),
                     row["ratio_se"].get<double>(), row["neighbours"].get<double>());
}

} // namespace mesobridge::workflows
