#include "cg/kolmogorov_smirnov.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <vector>

namespace mesobridge::cg {
namespace {

/// Q(lambda) = 2 sum_k (-1)^(k-1) exp(-2 k^2 lambda^2): the tail of Kolmogorov's distribution.
double kolmogorov_tail(double lambda) {
  if (lambda < 0.2)
    return 1; // differs from 1 by less than 1e-12, where the series would need very many terms
  double sum = 0;
  for (int k = 1; k <= 100; ++k) {
    double const term = std::exp(-2.0 * k * k * lambda * lambda);
    sum += k % 2 == 1 ? term : -term;
    if (term < 1e-16)
      break;
  }
  return std::min(1.0, 2 * sum);
}

} // namespace

double kolmogorov_smirnov_distance(std::span<double const> samples,
                                   std::function<double(double)> const& cdf) {
  require(samples.size() >= 8, "samples of a Kolmogorov-Smirnov test", samples.size(),
          "at least 8 are needed");
  std::vector<double> sorted(samples.begin(), samples.end());
  for (double x : sorted)
    require(std::isfinite(x), "sample", x, "must be finite");
  std::sort(sorted.begin(), sorted.end());
  double const n = double(sorted.size());
  double distance = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    double const law = cdf(sorted[k]);
    require(law >= 0 && law <= 1, "cumulative distribution", law, "must be in [0, 1]");
    distance = std::max({distance, law - double(k) / n, double(k + 1) / n - law});
  }
  return distance;
}

double kolmogorov_smirnov_p(std::span<double const> samples, std::function<double(double)> const& cdf) {
  double const distance = kolmogorov_smirnov_distance(samples, cdf);
  double const root = std::sqrt(double(samples.size()));
  return kolmogorov_tail((root + 0.12 + 0.11 / root) * distance);
}

} // namespace mesobridge::cg
