#pragma once
#include <cstddef>
#include <numbers>

namespace mesobridge::cg {

/// The lag in frames, not whole, at which a correlation of so many lags has come to 1/e of its first value;
/// the last one where it does not.
template <class Correlation>
double decay_lag(std::size_t lags, Correlation const& correlation) {
  double const goal = correlation(0) / std::numbers::e;
  for (std::size_t lag = 1; lag < lags; ++lag)
    if (double const now = correlation(lag), before = correlation(lag - 1); now < goal)
      return double(lag) - (goal - now) / (before - now);
  return double(lags - 1);
}

} // namespace mesobridge::cg
