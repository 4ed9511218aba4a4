#pragma once
#include "cg/histogram.hpp"

namespace mesobridge::cg {

/// Bins that hold all values of a sample times `unit`: its mean and eight standard deviations. None when
/// there are no values.
Bins bins_around(std::span<double const> values, double unit);

/// Quadratic distance of two densities on the same bins, relative to the second (cg/README.md, Eq. (C16)).
double distribution_error(std::span<double const> found, std::span<double const> reference);

/// The part of a distribution error that the finite sample makes: from the difference of its two halves.
double distribution_noise(std::span<double const> first_half, std::span<double const> second_half,
                          std::span<double const> reference);

} // namespace mesobridge::cg
