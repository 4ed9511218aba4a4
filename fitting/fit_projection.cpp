#include "fitting/fit_search.hpp"
#include "md/error.hpp"
#include <algorithm>

namespace mesobridge::fitting {
namespace {

/// Values of the linear parameters, each within its bounds.
struct Linear {
  FitCoordinates const& coordinates;
  Eigen::VectorXd u; ///< of all free parameters; those of the linear ones are replaced

  double low(std::size_t k) const { return coordinates.value(coordinates.linear()[k], 0); }
  double high(std::size_t k) const { return coordinates.value(coordinates.linear()[k], 1); }
  Eigen::VectorXd point(Eigen::VectorXd const& x) const {
    Eigen::VectorXd at = u;
    for (std::size_t k = 0; k < coordinates.linear().size(); ++k) {
      auto const coordinate = coordinates.linear()[k];
      at[coordinate] = std::clamp(coordinates.unit(coordinate, x[static_cast<Eigen::Index>(k)]), 0.0, 1.0);
    }
    return at;
  }
  std::optional<Eigen::VectorXd> residuals(Eigen::VectorXd const& x) const {
    return coordinates.residuals(point(x));
  }
};

/// Slopes of the residuals over the values; one-sided, which is exact where they are linear.
std::optional<Eigen::MatrixXd> slopes(Linear const& linear, Eigen::VectorXd const& x,
                                      Eigen::VectorXd const& r) {
  constexpr double of_value = 1e-4, of_range = 1e-6;
  Eigen::MatrixXd J(r.size(), x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    double const low = linear.low(std::size_t(k)), high = linear.high(std::size_t(k));
    double const size = std::max(of_value * std::abs(x[k]), of_range * (high - low));
    double const h = x[k] + size <= high ? size : -size;
    Eigen::VectorXd shifted = x;
    shifted[k] += h;
    auto const there = linear.residuals(shifted);
    if (!there)
      return std::nullopt;
    J.col(k) = (*there - r) / h;
  }
  return J;
}

/// The x within the bounds that minimises |r + J (x - from)|: what leaves the bounds is put on them, and the
/// rest solved again.
Eigen::VectorXd bounded_step(Linear const& linear, Eigen::VectorXd const& from, Eigen::VectorXd const& r,
                             Eigen::MatrixXd const& J) {
  Eigen::VectorXd x = from;
  std::vector<Eigen::Index> moving(static_cast<std::size_t>(x.size()));
  for (std::size_t k = 0; k < moving.size(); ++k)
    moving[k] = static_cast<Eigen::Index>(k);
  while (!moving.empty()) {
    Eigen::VectorXd const rest = r + J * (x - from);
    // The parameters differ by decades: their columns are scaled.
    Eigen::MatrixXd part = J(Eigen::all, moving);
    Eigen::VectorXd const scale = part.colwise().norm().cwiseMax(1e-300);
    part = part * scale.cwiseInverse().asDiagonal();
    Eigen::VectorXd const step = scale.cwiseInverse().asDiagonal() * part.colPivHouseholderQr().solve(-rest);
    std::vector<Eigen::Index> inside;
    for (std::size_t k = 0; k < moving.size(); ++k) {
      auto const at = moving[k];
      double const wanted = x[at] + step[static_cast<Eigen::Index>(k)];
      double const low = linear.low(std::size_t(at)), high = linear.high(std::size_t(at));
      x[at] = std::clamp(wanted, low, high);
      if (x[at] == wanted)
        inside.push_back(at);
    }
    if (inside.size() == moving.size())
      return x;
    for (auto const at : inside) // solved again beside what stands on its bound
      x[at] = from[at];
    moving = inside;
  }
  return x;
}

} // namespace

std::optional<Eigen::VectorXd> project_linear(FitCoordinates const& coordinates, Eigen::VectorXd const& u) {
  auto const size = static_cast<Eigen::Index>(coordinates.linear().size());
  Linear const linear{coordinates, u};
  Eigen::VectorXd x(size);
  for (Eigen::Index k = 0; k < size; ++k)
    x[k] = linear.low(std::size_t(k));
  auto r = linear.residuals(x);
  if (!r)
    return std::nullopt;
  constexpr int most_steps = 5, most_halvings = 4;
  constexpr double enough = 1e-4;
  for (int round = 0; round < most_steps; ++round) {
    auto const J = slopes(linear, x, *r);
    if (!J)
      break;
    Eigen::VectorXd to = bounded_step(linear, x, *r, *J);
    auto r_to = linear.residuals(to);
    for (int k = 0; k < most_halvings && !(r_to && r_to->squaredNorm() < r->squaredNorm()); ++k) {
      to = 0.5 * (x + to);
      r_to = linear.residuals(to);
    }
    if (!r_to || !(r_to->squaredNorm() < r->squaredNorm()))
      break;
    double const gain = r->squaredNorm() - r_to->squaredNorm();
    x = to, r = r_to;
    if (gain < enough * (1 + r->squaredNorm()))
      break;
  }
  return linear.point(x);
}

} // namespace mesobridge::fitting
