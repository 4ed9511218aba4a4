#pragma once
#include <cmath>
#include <random>
#include <vector>

namespace mesobridge::cg::test {

/// A stationary series x_t = phi x_{t-1} + noise of unit variance and given mean: rho(t) = phi^t, so its
/// integrated autocorrelation time is exactly (1 + phi)/(1 - phi)/2.
inline std::vector<double> ar1(std::size_t n, double phi, double mean, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  std::vector<double> series(n);
  double x = normal(generator);
  for (double& value : series) {
    value = mean + x;
    x = phi * x + std::sqrt(1 - phi * phi) * normal(generator);
  }
  return series;
}

inline double ar1_tau(double phi) {
  return 0.5 * (1 + phi) / (1 - phi);
}

} // namespace mesobridge::cg::test
