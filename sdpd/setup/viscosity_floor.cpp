#include "sdpd/setup/viscosity_floor.hpp"
#include "fitting/linear_gaussian.hpp"
#include "sdpd/setup/viscosity_line.hpp"
#include <algorithm>
#include <cmath>
#include <vector>

namespace mesobridge::sdpd {
namespace {

double value_of(ViscosityTrial const& one) {
  return one.realised.mean;
}
double pairs_of(ViscosityTrial const& one) {
  return one.pairs;
}

/// c_0 + c_1 d + c_2 d^2 in d = ln(pairs/origin).
class Parabola {
 public:
  /// Weighted least squares. Errors of few independent samples are rough themselves, hence the share that is
  /// added to them.
  Parabola(std::span<ViscosityTrial const> trials, ViscosityTrial const& origin)
      : fit_(fit(trials, origin.pairs, origin.realised.mean)) {
    for (auto const& one : trials)
      n_eff_ += one.realised.n_eff;
  }
  bool has_least() const { return fit_.mean[2] > 0; }
  double least_at() const { return -fit_.mean[1] / (2 * fit_.mean[2]); }
  cg::Estimate at(double d) const {
    Eigen::Vector3d const powers(1, d, d * d);
    return {powers.dot(fit_.mean), (fit_.spread.transpose() * powers).norm(), n_eff_};
  }

 private:
  static fitting::LinearPosterior fit(std::span<ViscosityTrial const> trials, double origin, double lowest) {
    constexpr double rough = 0.01;
    auto const count = static_cast<Eigen::Index>(trials.size());
    Eigen::MatrixXd A(count, 3);
    Eigen::VectorXd r(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      auto const& [pairs, y] = trials[static_cast<std::size_t>(k)];
      double const d = std::log(pairs / origin), sigma = std::hypot(y.se, rough * y.mean);
      A.row(k) = Eigen::RowVector3d(1, d, d * d) / sigma, r[k] = y.mean / sigma;
    }
    constexpr double wide = 100; // a prior that says nothing, over the lowest viscosity
    return fitting::LinearGaussian(A, r).posterior(wide * lowest);
  }

  fitting::LinearPosterior fit_;
  double n_eff_ = 0;
};

/// Different frictions, of which three make a parabola.
std::size_t different(std::vector<ViscosityTrial> const& sorted) {
  constexpr double apart = 0.02;
  std::size_t count = 1;
  for (std::size_t k = 1; k < sorted.size(); ++k)
    count += std::log(sorted[k].pairs / sorted[k - 1].pairs) > apart;
  return count;
}

/// What less friction takes away is as much as that, or half of it, or half as much again; motion, which then
/// carries more, takes away nothing.
ViscosityFloor without_friction(ViscosityTrial const& least, double least_pairs) {
  constexpr double slope = 1, slope_error = .5;
  double const less = std::max(0.0, least.pairs - least_pairs);
  auto const& [mean, se, n_eff] = least.realised;
  return {std::min(least.pairs, least_pairs),
          {mean - slope * less, std::hypot(se, slope_error * less), n_eff}};
}

} // namespace

ViscosityFloor viscosity_floor(std::span<ViscosityTrial const> trials, double least_pairs) {
  constexpr double about = 1.2; // of ln pairs: farther away it is no parabola
  double const smallest = std::ranges::min(trials, {}, pairs_of).pairs;
  auto const edge = without_friction({smallest, realised_by_line(trials, smallest)}, least_pairs);
  auto const lowest = std::ranges::min(trials, {}, value_of);
  std::vector<ViscosityTrial> near;
  std::ranges::copy_if(trials, std::back_inserter(near), [&](ViscosityTrial const& one) {
    return std::abs(std::log(one.pairs / lowest.pairs)) < about;
  });
  std::ranges::sort(near, {}, pairs_of);
  if (different(near) < 3)
    return edge;
  Parabola const parabola(near, lowest);
  double const d = parabola.least_at(), pairs = lowest.pairs * std::exp(d);
  auto const least = parabola.at(d), of_less = near.front().realised;
  if (!(parabola.has_least() && pairs > near.front().pairs && pairs < near.back().pairs &&
        of_less.mean > least.mean + 2 * std::hypot(of_less.se, least.se)))
    return edge;
  return {pairs, least, true};
}

} // namespace mesobridge::sdpd
