#include "sdpd/setup/viscosity_line.hpp"
#include "fitting/linear_gaussian.hpp"
#include <algorithm>
#include <cmath>
#include <vector>

namespace mesobridge::sdpd {

cg::Estimate realised_by_line(std::span<ViscosityTrial const> trials, double pairs) {
  constexpr double about = 0.25;                // of ln pairs: farther away the line bends
  constexpr double slope = 1, slope_error = .5; // before any trial: friction is all, or nearly
  constexpr double wide = 1e9;                  // a prior that says nothing, over a viscosity
  std::vector<ViscosityTrial> near;
  std::ranges::copy_if(trials, std::back_inserter(near),
                       [&](auto const& one) { return std::abs(std::log(one.pairs / pairs)) < about; });
  auto const n = static_cast<Eigen::Index>(near.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n + 1, 2);
  Eigen::VectorXd r(n + 1);
  double n_eff = 0;
  for (Eigen::Index k = 0; k < n; ++k) {
    auto const& [x, y] = near[static_cast<std::size_t>(k)];
    A.row(k) = Eigen::RowVector2d(1, x - pairs) / y.se, r[k] = y.mean / y.se;
    n_eff += y.n_eff;
  }
  A(n, 1) = 1 / slope_error, r[n] = slope / slope_error;
  auto const found = fitting::LinearGaussian(A, r).posterior(wide * std::abs(near.front().realised.mean));
  double const chi2 = (r - A * found.mean).squaredNorm(),
               widen = n > 1 ? std::max(1.0, chi2 / static_cast<double>(n - 1)) : 1;
  return {found.mean[0], std::sqrt(widen) * found.spread.row(0).norm(), n_eff};
}

} // namespace mesobridge::sdpd
