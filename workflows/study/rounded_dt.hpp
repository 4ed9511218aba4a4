#pragma once
#include <cmath>

namespace mesobridge::workflows {

/// The largest number of two digits that is not above a time step > 0.
inline double rounded_down(double dt) {
  double const unit = std::pow(10, std::floor(std::log10(dt)) - 1);
  return std::floor(dt / unit + 1e-9) * unit;
}

} // namespace mesobridge::workflows
