#include "workflows/lj_to_sdpd/results.hpp"
#include "cg/kolmogorov_smirnov.hpp"
#include "fitting/power_law.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_cdf.h>

namespace mesobridge::workflows {
namespace {

void fit(DriftLaw& law) {
  std::vector<cg::Estimate> rates;
  for (std::size_t k = 0; k < law.dt.size(); ++k) {
    rates.push_back({law.rate[k], law.se[k], 1});
    law.used += law.rate[k] > 2 * law.se[k];
  }
  auto const found = fitting::fit_power_law(law.dt, rates);
  if (!found.known())
    return;
  double const C = std::exp(found.log_prefactor.mean);
  law.exponent = found.exponent, law.prefactor = {C, C * found.log_prefactor.se, found.log_prefactor.n_eff};
}

} // namespace

std::vector<DriftLaw> drift_laws(std::vector<RunResult> const& runs) {
  std::vector<DriftLaw> laws;
  for (auto const& run : runs) {
    double const K = run.settings.K();
    auto found = std::find_if(laws.begin(), laws.end(), [K](DriftLaw const& law) { return law.K == K; });
    if (found == laws.end())
      found = laws.insert(laws.end(), DriftLaw{.K = K});
    found->dt.push_back(run.settings.dt);
    found->rate.push_back(run.equilibrium.drift.rate);
    found->se.push_back(run.equilibrium.drift.se);
  }
  for (auto& law : laws)
    fit(law);
  return laws;
}

GammaTest gamma_test(RunResult const& run) {
  double const thermal = run.settings.units().boltzmann * run.settings.T,
               shape = 1.5 * (run.settings.K() - 1);
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
