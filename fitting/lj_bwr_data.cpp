#include "fitting/lj_bwr_data.hpp"
#include "md/error.hpp"
#include <algorithm>

namespace mesobridge::fitting {
namespace {

double square(double x) {
  return x * x;
}

void check(cg::StatePoint const& point, double T_low) {
  auto const what = [&](char const* name) {
    return fmt::format("state (rho {}, T {}): {}", point.rho, point.T, name);
  };
  require(point.rho > 0 && std::isfinite(point.rho), what("rho"), point.rho, "must be > 0");
  require(point.T >= T_low && std::isfinite(point.T), what("T"), point.T,
          fmt::format("must be at least T_low = {}: colder states are continued, not fitted", T_low));
  require(std::isfinite(point.U.mean), what("U"), point.U.mean, "must be finite");
  require(std::isfinite(point.P.mean), what("P"), point.P.mean, "must be finite");
  require(point.U.se > 0 && std::isfinite(point.U.se), what("standard error of U"), point.U.se,
          "must be > 0");
  require(point.P.se > 0 && std::isfinite(point.P.se), what("standard error of P"), point.P.se,
          "must be > 0");
  require(std::abs(point.cov_UP) < point.U.se * point.P.se, what("covariance of U and P"), point.cov_UP,
          "must be smaller than the product of their standard errors");
}

} // namespace

std::vector<LjBwrDatum> prepare_lj_bwr_data(cg::StateGrid const& grid, double T_low,
                                            double relative_error_floor) {
  require(relative_error_floor >= 0 && relative_error_floor < 1, "relative error floor", relative_error_floor,
          "must be in [0, 1)");
  std::vector<LjBwrDatum> data;
  for (auto const& point : grid.points) {
    check(point, T_low);
    double const U = point.U.mean, P = point.P.mean, T = point.T, rho = point.rho;
    double const floor_U = relative_error_floor * std::max(std::abs(U), T);
    double const floor_P = relative_error_floor * std::max(std::abs(P), rho * T);
    Eigen::Matrix2d covariance;
    covariance << square(point.U.se) + square(floor_U), point.cov_UP, point.cov_UP,
        square(point.P.se) + square(floor_P);
    data.push_back({.rho = rho,
                    .T = T,
                    .y = {U, P},
                    .residual = {U - 1.5 * T, P - rho * T},
                    .noise = covariance.llt().matrixL()});
  }
  return data;
}

} // namespace mesobridge::fitting
