#include "fitting/fit_dpde.hpp"
#include "fitting/root.hpp"
#include <cmath>

namespace mesobridge::fitting {
namespace {

/// The energy at which the curve has a temperature inside its sampled range: T rises with U.
double energy_at(cg::EntropyCurve const& curve, double T) {
  double low = curve.U_low(), high = curve.U_high();
  // Curves of which blocks were left out reach a little less or more: they go on with constant C.
  while (curve.T(high) < T)
    high *= 1.1;
  while (curve.T(low) > T)
    low = 0.5 * (low + curve.U_zero());
  return bracketed_zero([&](double U) { return curve.T(U) - T; }, low, high);
}

std::vector<std::vector<double>> jackknife_covariance(cg::EntropyFit const& fit,
                                                      std::vector<double> const& T) {
  std::vector<std::vector<double>> values;
  for (auto const& curve : fit.without) {
    values.emplace_back();
    for (double const t : T)
      values.back().push_back(curve.C(energy_at(curve, t)));
  }
  double const blocks = double(values.size());
  std::vector<double> mean(T.size(), 0.0);
  for (auto const& row : values)
    for (std::size_t k = 0; k < T.size(); ++k)
      mean[k] += row[k] / blocks;
  std::vector<std::vector<double>> covariance(T.size(), std::vector<double>(T.size(), 0.0));
  for (auto const& row : values)
    for (std::size_t a = 0; a < T.size(); ++a)
      for (std::size_t b = 0; b < T.size(); ++b)
        covariance[a][b] += (blocks - 1) / blocks * (row[a] - mean[a]) * (row[b] - mean[b]);
  return covariance;
}

} // namespace

DpdeFit fit_dpde(cg::EntropyFit const& fit, DpdeRange const& range) {
  auto const& curve = fit.curve;
  double const T_low = curve.T(curve.U_low()), T_high = curve.T(curve.U_high());
  require(range.points >= 4, "points of the table", range.points, "must be at least 4");
  require(range.T_min > 0 && range.T_min < T_low, "lowest temperature of the model", range.T_min,
          fmt::format("must be in (0, {:.4g}), below the sampled ones", T_low));
  require(range.T_max > T_high && std::isfinite(range.T_max), "highest temperature of the model", range.T_max,
          fmt::format("must be above the sampled ones, {:.4g}", T_high));
  DpdeFit result{.T_table = {},
                 .C_table = {},
                 .eps_min = 0,
                 .T = {},
                 .C = {},
                 .eps = {},
                 .covariance = {},
                 .T_sampled_low = T_low,
                 .T_sampled_high = T_high};
  for (std::size_t k = 0; k < range.points; ++k) {
    double const T = std::lerp(T_low, T_high, double(k) / double(range.points - 1));
    result.T.push_back(T);
    result.C.push_back(fit.estimate([&](auto const& c) { return c.C(energy_at(c, T)); }));
    result.eps.push_back(fit.estimate([&](auto const& c) { return energy_at(c, T); }));
  }
  result.covariance = jackknife_covariance(fit, result.T);
  std::vector<double> T{range.T_min}, C{curve.C(curve.U_low())};
  for (double const t : result.T) {
    T.push_back(t);
    C.push_back(curve.C(energy_at(curve, t)));
  }
  T.push_back(range.T_max), C.push_back(curve.C(curve.U_high()));
  for (std::size_t k = 0; k < T.size(); ++k)
    if (!(C[k] > 0))
      throw PhysicsError(
          fmt::format("the heat capacity of the blob is {:.4g} at T = {:.4g}: it must be positive. "
                      "Lower the order, or sample more",
                      C[k], T[k]));
  result.eps_min = curve.U_low() - C.front() * (T_low - range.T_min);
  result.T_table = std::move(T), result.C_table = std::move(C);
  return result;
}

TabulatedHeatCapacity internal_energy_of(DpdeFit const& fit) {
  return {fit.T_table, fit.C_table, fit.eps_min};
}

} // namespace mesobridge::fitting
