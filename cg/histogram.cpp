#include "cg/histogram.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {

Histogram histogram(std::span<double const> samples, double lower, double upper, std::size_t bins,
                    double inefficiency) {
  require(!samples.empty(), "samples of a histogram", samples.size(), "at least one is needed");
  require(bins > 0, "bins of a histogram", bins, "at least one is needed");
  require(std::isfinite(lower) && std::isfinite(upper) && upper > lower, "upper end of a histogram", upper,
          "must be finite and above the lower end");
  require(inefficiency > 0, "statistical inefficiency", inefficiency, "must be > 0");
  Histogram result{
      .lower = lower, .upper = upper, .counts = std::vector<std::size_t>(bins), .density = {}, .se = {}};
  for (double x : samples) {
    require(std::isfinite(x), "sample", x, "must be finite");
    if (x < lower)
      ++result.below;
    else if (x >= upper)
      ++result.above;
    else // rounding can carry the last numbers below the upper end into a bin that is not there
      ++result.counts[std::min(bins - 1, std::size_t((x - lower) / (upper - lower) * double(bins)))];
  }
  double const n = double(samples.size());
  for (std::size_t count : result.counts) {
    double const p = (double(count) + 1) / (n + 2);
    result.density.push_back(double(count) / n / result.width());
    result.se.push_back(std::sqrt(p * (1 - p) * inefficiency / n) / result.width());
  }
  return result;
}

} // namespace mesobridge::cg
