#include "fitting/power_law.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_fit.h>
#include <vector>

namespace mesobridge::fitting {

cg::Estimate PowerLaw::logarithm_at(double x) const {
  double const u = std::log(x);
  double const variance =
      log_prefactor.se * log_prefactor.se + 2 * u * covariance + u * u * exponent.se * exponent.se;
  return {log_prefactor.mean + exponent.mean * u, std::sqrt(std::max(0.0, variance)), exponent.n_eff};
}

double PowerLaw::x_of(double y) const {
  return std::exp((std::log(y) - log_prefactor.mean) / exponent.mean);
}

double PowerLaw::x_surely_below(double y) const {
  double const n = exponent.mean, variance = exponent.se * exponent.se;
  double const curvature = n * n - variance;
  if (!(n > 0 && curvature > 0))
    return 0;
  // The smaller root u = ln x of (ln y - ln C - n u)^2 = variance of ln C + n u: there the left root is > 0.
  double const above = std::log(y) - log_prefactor.mean;
  double const half = above * n + covariance;
  double const product = above * above - log_prefactor.se * log_prefactor.se;
  return std::exp((half - std::sqrt(std::max(0.0, half * half - curvature * product))) / curvature);
}

PowerLaw fit_power_law(std::span<double const> x, std::span<cg::Estimate const> y) {
  constexpr double trusted = 0.05;
  std::vector<double> u, v, weight;
  PowerLaw law;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (y[k].mean > 2 * y[k].se) {
      double const relative = std::hypot(y[k].se / y[k].mean, trusted);
      u.push_back(std::log(x[k])), v.push_back(std::log(y[k].mean)),
          weight.push_back(1 / (relative * relative));
      law.x_min = u.size() == 1 ? x[k] : std::min(law.x_min, x[k]);
      law.x_max = std::max(law.x_max, x[k]);
    }
  double const n = static_cast<double>(u.size());
  if (u.size() < 3)
    return law;
  double offset, slope, var_offset, covariance, var_slope, chi_2;
  gsl_fit_wlinear(u.data(), 1, weight.data(), 1, v.data(), 1, u.size(), &offset, &slope, &var_offset,
                  &covariance, &var_slope, &chi_2);
  double const widen = std::max(1.0, chi_2 / (n - 2));
  law.exponent = {slope, std::sqrt(widen * var_slope), n};
  law.log_prefactor = {offset, std::sqrt(widen * var_offset), n};
  law.covariance = widen * covariance;
  return law;
}

} // namespace mesobridge::fitting
