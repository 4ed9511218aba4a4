#include "cg/equilibration.hpp"
#include "cg/estimate.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <limits>
#include <vector>

namespace mesobridge::cg {
namespace {
constexpr std::size_t fewest_samples = 40;
} // namespace

Equilibration detect_equilibration(std::span<double const> series) {
  std::size_t const n = series.size();
  require(n >= fewest_samples, "samples to find the equilibration in", n, "at least 40 are needed");
  std::size_t const stride = std::max<std::size_t>(1, n / 50);
  Equilibration best;
  for (std::size_t start = 0; start <= 3 * n / 4; start += stride) {
    auto const memory = autocorrelation_time(series.subspan(start));
    double const n_eff = double(n - start) / memory.inefficiency();
    if (n_eff > best.n_eff)
      best = {start, memory.tau, n_eff};
  }
  return best;
}

std::size_t marginal_standard_error_start(std::span<double const> series) {
  constexpr std::size_t batch = 5;
  require(series.size() >= fewest_samples, "samples to find the equilibration in", series.size(),
          "at least 40 are needed");
  std::vector<double> means(series.size() / batch);
  for (std::size_t k = 0; k < means.size(); ++k) {
    for (std::size_t j = 0; j < batch; ++j)
      means[k] += (series[k * batch + j] - series.back()) /
                  batch; // the shift keeps the sums below free of cancellation
  }
  double sum = 0, squares = 0, best = std::numeric_limits<double>::infinity();
  std::size_t start = 0;
  for (std::size_t kept = 1; kept <= means.size(); ++kept) {
    double const x = means[means.size() - kept];
    sum += x, squares += x * x;
    double const n = double(kept);
    double const se_squared = (squares - sum * sum / n) / (n * n);
    if (2 * kept >= means.size() && se_squared <= best) {
      best = se_squared;
      start = (means.size() - kept) * batch;
    }
  }
  return start;
}

} // namespace mesobridge::cg
