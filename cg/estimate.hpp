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

/// True when the estimate lies within z standard errors of the value.
bool agrees(Estimate const& estimate, double value, double z);

/// How many standard errors the estimate is away from the value (signed).
double deviation(Estimate const& estimate, double value);

} // namespace mesobridge::cg
