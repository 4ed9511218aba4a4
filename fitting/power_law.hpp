#pragma once
#include "cg/estimate.hpp"
#include <span>

namespace mesobridge::fitting {

/// y = C x^n through points with errors.
struct PowerLaw {
  cg::Estimate exponent, log_prefactor; ///< n_eff counts the points used
  double covariance = 0;                ///< of the two
  double x_min = 0, x_max = 0;          ///< of the points used

  bool known() const { return exponent.n_eff >= 3; }
  /// y at x with the standard error of its logarithm.
  cg::Estimate logarithm_at(double x) const;
  /// The x where y reaches a value.
  double x_of(double y) const;
  /// The largest x at which y > 0 is not exceeded by the law with one standard error of its logarithm; 0
  /// where the exponent is not above its own standard error, so that no x is known to be.
  double x_surely_below(double y) const;
};

/// Weighted least squares in logarithms through the points that are resolved (y > 2 se); beyond its own error
/// no point is trusted to better than 5 %, and errors are widened when the points scatter more than theirs
/// allow. Not known() when fewer than three points are resolved.
PowerLaw fit_power_law(std::span<double const> x, std::span<cg::Estimate const> y);

} // namespace mesobridge::fitting
