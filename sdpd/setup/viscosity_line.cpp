#include "sdpd/setup/viscosity_line.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::sdpd {

cg::Estimate realised_by_line(std::span<ViscosityTrial const> trials, double pairs) {
  constexpr double about = 0.25;                // of ln pairs: farther away the line bends
  constexpr double slope = 1, slope_error = .5; // before any trial: friction is all, or nearly
  double w = 0, wx = 0, wy = 0, wxx = 1 / (slope_error * slope_error), wxy = slope * wxx, n = 0, n_eff = 0;
  auto const for_each_near = [&](auto const& f) {
    for (auto const& one : trials)
      if (std::abs(std::log(one.pairs / pairs)) < about)
        f(one.pairs - pairs, one.realised);
  };
  for_each_near([&](double x, cg::Estimate const& y) {
    double const weight = 1 / (y.se * y.se);
    w += weight, wx += weight * x, wxx += weight * x * x;
    wy += weight * y.mean, wxy += weight * x * y.mean;
    n += 1, n_eff += y.n_eff;
  });
  double const determinant = w * wxx - wx * wx;
  double const at = (wxx * wy - wx * wxy) / determinant, rise = (w * wxy - wx * wy) / determinant;
  double chi2 = std::pow((rise - slope) / slope_error, 2);
  for_each_near(
      [&](double x, cg::Estimate const& y) { chi2 += std::pow((at + rise * x - y.mean) / y.se, 2); });
  double const widen = n > 1 ? std::max(1.0, chi2 / (n - 1)) : 1;
  return {at, std::sqrt(widen * wxx / determinant), n_eff};
}

} // namespace mesobridge::sdpd
