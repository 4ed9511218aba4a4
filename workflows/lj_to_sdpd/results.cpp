#include "workflows/lj_to_sdpd/results.hpp"
#include "cg/kolmogorov_smirnov.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

namespace mesobridge::workflows {
namespace {

void fit_power_law(DriftLaw& law) {
  std::vector<double> x, y, weight;
  for (std::size_t k = 0; k < law.dt.size(); ++k)
    if (law.rate[k] > 2 * law.se[k]) {
      x.push_back(std::log(law.dt[k])), y.push_back(std::log(law.rate[k]));
      // Beyond its own error a rate need not lie on the law to better than some percent.
      double const relative = std::hypot(law.se[k] / law.rate[k], 0.05);
      weight.push_back(1 / (relative * relative));
    }
  law.used = x.size();
  if (law.used < 3)
    return;
  double offset, slope, var_offset, cov, var_slope, chi_2;
  gsl_fit_wlinear(x.data(), 1, weight.data(), 1, y.data(), 1, x.size(), &offset, &slope, &var_offset, &cov,
                  &var_slope, &chi_2);
  // Errors are widened when the points scatter more than theirs allow.
  double const widen = std::sqrt(std::max(1.0, chi_2 / double(law.used - 2)));
  law.exponent = {slope, widen * std::sqrt(var_slope), double(law.used)};
  double const C = std::exp(offset);
  law.prefactor = {C, C * widen * std::sqrt(var_offset), double(law.used)};
}

} // namespace

std::vector<DriftLaw> drift_laws(std::vector<RunResult> const& runs) {
  std::vector<DriftLaw> laws;
  for (auto const& run : runs) {
    double const K = run.settings.K;
    auto found = std::find_if(laws.begin(), laws.end(), [K](DriftLaw const& law) { return law.K == K; });
    if (found == laws.end())
      found = laws.insert(laws.end(), DriftLaw{.K = K});
    found->dt.push_back(run.settings.dt);
    found->rate.push_back(run.equilibrium.drift.rate);
    found->se.push_back(run.equilibrium.drift.se);
  }
  for (auto& law : laws)
    fit_power_law(law);
  return laws;
}

GammaTest gamma_test(RunResult const& run) {
  double const thermal = run.settings.units().boltzmann * run.settings.T, shape = 1.5 * (run.settings.K - 1);
  std::vector<double> energies(run.eps);
  for (auto& energy : energies)
    energy /= thermal;
  auto const cdf = [shape](double x) { return gsl_cdf_gamma_P(x, shape, 1); };
  return {cg::kolmogorov_smirnov_distance(energies, cdf), cg::kolmogorov_smirnov_p(energies, cdf),
          energies.size()};
}

ThesisMeans thesis_means(double K) {
  return {1.266 - 0.088 / K + 0.394 / (K * K), 1116 + 187 / K - 167 / (K * K),
          0.649 + 0.178 / K + 0.612 / (K * K)};
}

ThesisMeans thesis_variances(double K) {
  return {1.81 * std::pow(K, -1.008), 2.5e4 * std::pow(K, -0.924), 0.114 * std::pow(K, -1.004)};
}

} // namespace mesobridge::workflows
