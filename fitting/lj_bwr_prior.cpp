#include "fitting/lj_bwr_prior.hpp"
#include "fitting/lj_bwr_design.hpp"
#include <vector>

namespace mesobridge::fitting {
namespace {

/// Rows for U and P, each divided by its scale, on a grid over the region; and the published values so
/// scaled.
struct RegionDesign {
  Eigen::MatrixXd rows;
  Eigen::VectorXd published;
};

RegionDesign region_design(LjRegion const& region, double gamma, bool relative_to_value) {
  constexpr int densities = 32, temperatures = 24;
  Eigen::Map<Eigen::VectorXd const> const x(lj_bwr_1993.x.data(), bwr::parameters);
  RegionDesign design{Eigen::MatrixXd(2 * densities * temperatures, bwr::parameters),
                      Eigen::VectorXd(2 * densities * temperatures)};
  int row = 0;
  for_each_state(region, densities, temperatures, [&](double rho, double T) {
    auto const [U_row, P_row] = residual_rows(rho, T, gamma);
    auto const published = residual_rows(rho, T, lj_bwr_1993.gamma);
    double const U = published.U * x, P = published.P * x; // residual parts
    double U_scale = T, P_scale = rho * T;
    if (relative_to_value) {
      U_scale = std::max(U_scale, std::abs(1.5 * T + U));
      P_scale = std::max(P_scale, std::abs(rho * T + P));
    }
    design.rows.row(row) = U_row / U_scale;
    design.published(row++) = U / U_scale;
    design.rows.row(row) = P_row / P_scale;
    design.published(row++) = P / P_scale;
  });
  return design;
}

} // namespace

ParameterPrior published_prior(LjRegion const& region, double gamma) {
  auto const design = region_design(region, gamma, true);
  Eigen::HouseholderQR<Eigen::MatrixXd> const qr(design.rows);
  Eigen::VectorXd centre = Eigen::Map<Eigen::VectorXd const>(lj_bwr_1993.x.data(), bwr::parameters);
  if (gamma != lj_bwr_1993.gamma)
    centre = qr.solve(design.published);
  // Scaled so that the mean over the rows q of q (R^T R)^-1 q^T is 1.
  double const scale = std::sqrt(double(bwr::parameters) / static_cast<double>(design.rows.rows()));
  Eigen::MatrixXd const R = qr.matrixQR().topRows(bwr::parameters).triangularView<Eigen::Upper>();
  return {centre, scale * R};
}

ParameterPrior wide_prior(LjRegion const& region, double gamma) {
  auto const design = region_design(region, gamma, false);
  Eigen::VectorXd const rms =
      (design.rows.colwise().squaredNorm() / static_cast<double>(design.rows.rows())).cwiseSqrt().transpose();
  return {Eigen::VectorXd::Zero(bwr::parameters), rms.asDiagonal()};
}

} // namespace mesobridge::fitting
