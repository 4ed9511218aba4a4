#include "sdpd/observe/equilibrium.hpp"
#include <algorithm>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::sdpd {
namespace {

double slope(std::span<double const> x, std::span<double const> y) {
  double offset, rate, cov_00, cov_01, cov_11, sum_of_squares;
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &offset, &rate, &cov_00, &cov_01, &cov_11,
                 &sum_of_squares);
  return rate;
}

} // namespace

Drift energy_drift(std::span<double const> times, std::span<double const> energies) {
  std::size_t const n = times.size(), segments = 8;
  require(n >= 32 && n == energies.size(), "samples for an energy drift", n,
          "must be at least 32, times and energies alike");
  std::vector<double> error(n);
  for (std::size_t k = 0; k < n; ++k)
    error[k] = energies[k] / energies[0] - 1;
  std::array<double, 8> rates;
  for (std::size_t s = 0; s < segments; ++s) {
    std::size_t const begin = s * n / segments, end = (s + 1) * n / segments;
    rates[s] = slope(times.subspan(begin, end - begin), std::span(error).subspan(begin, end - begin));
  }
  return {slope(times, error), gsl_stats_sd(rates.data(), 1, segments) / std::sqrt(double(segments))};
}

std::size_t samples_before_heating(std::span<double const> energies, double heat) {
  auto const heated =
      std::ranges::find_if(energies, [&](double E) { return !(std::abs(E - energies[0]) <= heat); });
  return static_cast<std::size_t>(heated - energies.begin());
}

InstantMoments moments(Snapshot const& now) {
  auto mean = [](std::vector<double> const& x) {
    return x.empty() ? 0 : gsl_stats_mean(x.data(), 1, x.size());
  };
  auto variance = [](std::vector<double> const& x) {
    return x.empty() ? 0 : gsl_stats_variance(x.data(), 1, x.size());
  };
  return {mean(now.eps), variance(now.eps), mean(now.rho), variance(now.rho), mean(now.P), variance(now.P)};
}

void EquilibriumSampler::sample(double time, double energy, double T_kin, double T_int, double P) {
  times_.push_back(time), energies_.push_back(energy);
  T_kin_.push_back(T_kin), T_int_.push_back(T_int), P_.push_back(P);
}

std::vector<double> EquilibriumSampler::at_instants(double InstantMoments::*quantity) const {
  std::vector<double> values;
  for (auto const& instant : moments_)
    values.push_back(instant.*quantity);
  return values;
}

ParticleMoments EquilibriumSampler::estimate(double InstantMoments::*mean,
                                             double InstantMoments::*variance) const {
  return {cg::estimate_mean(at_instants(mean)), cg::estimate_mean(at_instants(variance))};
}

/// From the mean of 1/T where the instants are harmonic means themselves.
cg::Estimate EquilibriumSampler::internal_temperature() const {
  if (!features_.energies)
    return {};
  if (features_.densities)
    return cg::estimate_mean(T_int_);
  std::vector<double> inverse;
  for (double const T : T_int_)
    inverse.push_back(1 / T);
  auto const mean = cg::estimate_mean(inverse);
  return {1 / mean.mean, mean.se / (mean.mean * mean.mean), mean.n_eff};
}

Equilibrium EquilibriumSampler::result() const {
  require(times_.size() >= 32, "samples", times_.size(),
          "at least 32 are needed for errors: run longer or sample more often");
  require(!features_.energies || moments_.size() >= 16, "samples of the particles", moments_.size(),
          "at least 16 are needed for errors: run longer or sample more often");
  using M = InstantMoments;
  return {cg::estimate_mean(T_kin_),
          internal_temperature(),
          cg::estimate_mean(P_),
          features_.energies ? estimate(&M::eps_mean, &M::eps_variance) : ParticleMoments(),
          features_.densities ? estimate(&M::rho_mean, &M::rho_variance) : ParticleMoments(),
          features_.densities ? estimate(&M::P_mean, &M::P_variance) : ParticleMoments(),
          features_.densities ? cg::estimate_mean(at_instants(&M::pairing)) : cg::Estimate(),
          features_.densities ? cg::estimate_mean(at_instants(&M::crystal)) : cg::Estimate(),
          energy_drift(times_, energies_)};
}

} // namespace mesobridge::sdpd
