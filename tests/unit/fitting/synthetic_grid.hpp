#pragma once
#include "fitting/fit_lj_bwr.hpp"
#include <random>

namespace mesobridge::fitting::test {

/// The states of a small campaign: the supercritical fluid between rho* 0.55 and 1.0, T* 3 and 11.
struct Campaign {
  int densities = 6, temperatures = 5;
  double relative_noise = 0.002; ///< of P; of U half of it, in units of max(|U|, T)
  double correlation = 0.6;      ///< of the errors of U and P
};

inline cg::StatePoint measured(LjBwr const& truth, double rho, double T, Campaign const& campaign,
                               std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  auto const isochore = truth.isochore(rho);
  double const U = isochore.energy(T), P = isochore.pressure(T), r = campaign.correlation;
  double const se_U = 0.5 * campaign.relative_noise * std::max(std::abs(U), T);
  double const se_P = campaign.relative_noise * P;
  double const a = normal(generator), b = r * a + std::sqrt(1 - r * r) * normal(generator);
  cg::StatePoint point;
  point.rho = rho;
  point.T = T;
  point.U = {.mean = U + se_U * a, .se = se_U, .n_eff = 100};
  point.P = {.mean = P + se_P * b, .se = se_P, .n_eff = 100};
  point.cov_UP = r * se_U * se_P;
  return point;
}

inline cg::StateGrid measured_grid(LjBwr const& truth, Campaign const& campaign, std::mt19937_64& generator) {
  cg::StateGrid grid;
  for (int i = 0; i < campaign.densities; ++i)
    for (int j = 0; j < campaign.temperatures; ++j)
      grid.points.push_back(measured(truth, 0.55 + 0.45 * i / (campaign.densities - 1),
                                     3 + 8.0 * j / (campaign.temperatures - 1), campaign, generator));
  return grid;
}

inline LjRegion wide_region() {
  return {0.01, lj_bwr_1993.rho_max, lj_bwr_1993.T_low, lj_bwr_1993.T_max};
}

/// A thermodynamically consistent fluid that differs from the published one by about `width` in U and P.
inline LjBwr different_fluid(double width, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  auto const prior = published_prior(wide_region(), lj_bwr_1993.gamma);
  Eigen::VectorXd u(bwr::parameters);
  for (auto& component : u)
    component = width * normal(generator);
  LjBwrSet set = lj_bwr_1993;
  Eigen::Map<Eigen::VectorXd>(set.x.data(), bwr::parameters) +=
      prior.R.triangularView<Eigen::Upper>().solve(u).eval();
  return LjBwr(set);
}

} // namespace mesobridge::fitting::test
