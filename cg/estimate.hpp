#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace mesobridge::cg {

/// A mean with its standard error and the number of independent samples behind it.
struct Estimate {
  double mean = 0;
  double se = 0;
  double n_eff = 0;
};

/// The same in another unit, factor > 0.
inline Estimate scaled(Estimate const& e, double factor) {
  return {e.mean * factor, e.se * factor, e.n_eff};
}

/// True when the estimate lies within z standard errors of the value.
bool agrees(Estimate const& estimate, double value, double z);

/// How many standard errors the estimate is away from the value (signed); an exact estimate (se = 0) is 0
/// away from its own mean and infinitely far from every other value.
double deviation(Estimate const& estimate, double value);

/// The memory of a stationary series x_1 ... x_n taken at equal intervals.
struct Autocorrelation {
  double variance = 0; ///< of one sample, freed from the bias that the unknown mean brings
  double tau =
      0.5; ///< integrated autocorrelation time 1/2 + sum_{t>0} rho(t), in samples: 1/2 without memory
  double tau_se = 0;      ///< standard error of tau
  std::size_t window = 0; ///< where the sum over t was cut

  /// Samples per independent sample, 2 tau.
  double inefficiency() const { return 2 * tau; }
};

/// Autocovariance Gamma(t) = <(x_i - mean)(x_{i+t} - mean)> for t = 0 ... max_lag, each over its n - t pairs.
/// By FFT, O(n log n). Throws InputError for fewer than 2 samples, max_lag >= n, or a sample that is not
/// finite.
std::vector<double> autocovariance(std::span<double const> series, std::size_t max_lag);

/// Integrated autocorrelation time by the Gamma method: the automatic window that balances truncation and
/// noise and the correction of the O(1/n) bias of Wolff, Comput. Phys. Commun. 156, 143 (2004), section 3,
/// with S = 1.5. Throws InputError for fewer than 4 samples or a sample that is not finite.
Autocorrelation autocorrelation_time(std::span<double const> series);

/// Mean and standard error from the integrated autocorrelation time.
Estimate estimate_by_autocorrelation(std::span<double const> series);

/// Mean and standard error by averaging over blocks (Flyvbjerg and Petersen, J. Chem. Phys. 91, 461 (1989));
/// block lengths are powers of two and the plateau is taken at the first length B with B^3 > 2 n
/// (se_B/se_1)^4 (Lee et al., Phys. Rev. E 83, 066706 (2011)); the longest with 8 blocks if there is none.
/// Throws InputError for fewer than 16 samples.
Estimate estimate_by_blocking(std::span<double const> series);

/// Mean and standard error: by autocorrelation time; by pairs of lags (cg/README.md, Eq. (C50)) or blocking
/// where those find more: a slow mode of small amplitude ends the window too soon; then enlarged by its own
/// uncertainty (C51). Throws InputError for fewer than 16 samples.
Estimate estimate_mean(std::span<double const> series);

/// Variance of one sample with its standard error (the error propagated linearly through the squared
/// deviations, with their own correlation time).
Estimate estimate_variance(std::span<double const> series);

/// Covariance of the means of two series taken at the same instants, with their correlation in time.
double covariance_of_means(std::span<double const> a, std::span<double const> b);

} // namespace mesobridge::cg
