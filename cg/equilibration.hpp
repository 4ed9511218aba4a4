#pragma once
#include <cstddef>
#include <span>

namespace mesobridge::cg {

/// Where the stationary part of a series begins.
struct Equilibration {
  std::size_t start = 0; ///< the first sample to keep
  double tau = 0.5;      ///< integrated autocorrelation time of what is kept, in samples
  double n_eff = 0;      ///< independent samples in what is kept
};

/// The start that leaves the most independent samples (Chodera, J. Chem. Theory Comput. 12, 1799 (2016)),
/// searched in steps of 2 % of the series over its first three quarters. Throws InputError for fewer than 40
/// samples.
Equilibration detect_equilibration(std::span<double const> series);

/// The start that makes the squared standard error of the mean, var/n of what is kept, smallest (White's
/// marginal standard error rule, in batches of 5), searched over the first half. A second opinion that does
/// not look at correlations. Throws InputError for fewer than 40 samples.
std::size_t marginal_standard_error_start(std::span<double const> series);

} // namespace mesobridge::cg
