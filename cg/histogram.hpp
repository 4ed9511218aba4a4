#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace mesobridge::cg {

/// Equal bins of [lower, upper).
struct Bins {
  double lower = 0, upper = 0;
  std::size_t count = 150;

  double width() const { return (upper - lower) / static_cast<double>(count); }
};

/// A probability density on equal bins, with standard errors.
struct Histogram {
  double lower = 0, upper = 0;
  std::vector<std::size_t> counts;
  std::size_t below = 0, above = 0; ///< samples outside [lower, upper)
  std::vector<double> density;      ///< normalised over all samples, those outside included
  std::vector<double> se;

  double width() const { return (upper - lower) / double(counts.size()); }
  double centre(std::size_t bin) const { return lower + (double(bin) + 0.5) * width(); }
};

/// Counts samples into `bins` equal bins of [lower, upper). `inefficiency` is the number of samples that make
/// one independent sample (2 tau; 1 for independent ones) and widens the errors. The error of a bin takes
/// (count + 1)/(n + 2) for its probability, so that an empty bin has an error too. Throws InputError for an
/// empty range, no bins, no samples or a sample that is not finite.
Histogram histogram(std::span<double const> samples, double lower, double upper, std::size_t bins,
                    double inefficiency = 1);

} // namespace mesobridge::cg
