#pragma once
#include <functional>
#include <span>

namespace mesobridge::cg {

/// The largest distance between the empirical distribution of the samples and the law `cdf`.
double kolmogorov_smirnov_distance(std::span<double const> samples, std::function<double(double)> const& cdf);

/// The probability that so large a distance arises by chance when the samples are independent and follow
/// `cdf` (asymptotic law with Stephens's correction, good to 0.01 from 8 samples on). Correlated samples must
/// be thinned first. Throws InputError for fewer than 8 samples, a sample that is not finite, or a cdf
/// outside [0, 1].
double kolmogorov_smirnov_p(std::span<double const> samples, std::function<double(double)> const& cdf);

} // namespace mesobridge::cg
