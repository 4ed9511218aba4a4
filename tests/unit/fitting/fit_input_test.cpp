#include "fitting/eos/list.hpp"
#include "fitting/lj_bwr_design.hpp"
#include "unit/fitting/synthetic_grid.hpp"
#include <functional>
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

cg::StateGrid good_grid(Campaign const& campaign = {}) {
  std::mt19937_64 generator(11);
  return measured_grid(LjBwr(lj_bwr_1993), campaign, generator);
}

TEST(FitInput, RowsTimesParametersAreTheEquation) {
  Eigen::Map<Eigen::VectorXd const> const x(lj_bwr_1993.x.data(), bwr::parameters);
  LjBwr const lj(lj_bwr_1993);
  int cases = 0;
  for (double rho : {0.02, 0.5, 1.2})
    for (double T : {0.9, 4.0, 60.0}) {
      auto const rows = residual_rows(rho, T, lj_bwr_1993.gamma);
      EXPECT_NEAR(1.5 * T + rows.U * x, lj.isochore(rho).energy(T), 1e-10);
      EXPECT_NEAR(rho * T + rows.P * x, lj.isochore(rho).pressure(T), 1e-10);
      ++cases;
    }
  EXPECT_EQ(cases, 9);
}

TEST(FitInput, NoiseIsTheCovarianceOfTheStateAndTheFloor) {
  cg::StatePoint point;
  point.rho = 0.8, point.T = 5;
  point.U = {.mean = -3, .se = 0.02, .n_eff = 100};
  point.P = {.mean = 20, .se = 0.05, .n_eff = 100};
  point.cov_UP = 0.0007;
  int cases = 0;
  for (double floor : {0.0, 0.01}) {
    auto const data = prepare_lj_bwr_data({{point}}, 1, floor);
    Eigen::Matrix2d const covariance = data[0].noise * data[0].noise.transpose();
    EXPECT_NEAR(covariance(0, 0), 0.02 * 0.02 + floor * floor * 25, 1e-15); // of max(|U|, T) = 5
    EXPECT_NEAR(covariance(1, 1), 0.05 * 0.05 + floor * floor * 400, 1e-15);
    EXPECT_NEAR(covariance(0, 1), 0.0007, 1e-15);
    EXPECT_DOUBLE_EQ(data[0].residual(0), -3 - 7.5);
    EXPECT_DOUBLE_EQ(data[0].residual(1), 20 - 4);
    ++cases;
  }
  EXPECT_EQ(cases, 2);
}

TEST(FitInput, BadStatesAreRefusedByName) {
  struct Case {
    std::function<void(cg::StatePoint&)> spoil;
    std::string named;
  };
  std::vector<Case> const cases{
      {[](auto& p) { p.P.mean = NAN; }, "P = nan"},
      {[](auto& p) { p.U.mean = INFINITY; }, "U = inf"},
      {[](auto& p) { p.P.se = 0; }, "standard error of P"},
      {[](auto& p) { p.U.se = NAN; }, "standard error of U"},
      {[](auto& p) { p.cov_UP = p.U.se * p.P.se; }, "covariance"},
      {[](auto& p) { p.cov_UP = NAN; }, "covariance"},
      {[](auto& p) { p.rho = -0.1; }, "rho"},
      {[](auto& p) { p.T = 0.7; }, "T_low"},
      {[](auto& p) { p.rho = 1.31; }, "rho* up to 1.31"},
  };
  std::size_t refused = 0;
  for (auto const& [spoil, named] : cases) {
    auto grid = good_grid();
    spoil(grid.points[7]);
    try {
      fit_lj_bwr(grid);
      ADD_FAILURE() << "accepted: " << named;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_EQ(refused, cases.size());
}

TEST(FitInput, TooFewStatesAreRefused) {
  auto grid = good_grid();
  grid.points.resize(2);
  EXPECT_THROW(fit_lj_bwr(grid), InputError);
  EXPECT_THROW(fit_lj_bwr({}), InputError);
  auto few = good_grid();
  few.points.resize(19);
  EXPECT_THROW(fit_lj_bwr(few, {.prior = LjBwrPrior::none}), InputError);
  EXPECT_NO_THROW(fit_lj_bwr(few));
}

TEST(FitInput, BadOptionsAreRefused) {
  auto const grid = good_grid();
  EXPECT_THROW(fit_lj_bwr(grid, {.prior_width = 0.0}), InputError);
  EXPECT_THROW(fit_lj_bwr(grid, {.prior_width = double(NAN)}), InputError);
  EXPECT_THROW(fit_lj_bwr(grid, {.relative_error_floor = -0.1}), InputError);
  EXPECT_THROW(fit_lj_bwr(grid, {.folds = 1}), InputError);
  EXPECT_THROW(fit_lj_bwr(grid, {.folds = 31}), InputError);
  EXPECT_THROW(fit_lj_bwr(grid, {.T_low = 3.5}), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
