#include "sdpd/observe/set_energy.hpp"
#include "fitting/eos/evaluate.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

/// The temperature of all degrees of freedom at the samples, had the energy stayed what it was at first: what
/// is left is the exchange with the elastic energy of the densities.
std::vector<double> temperature_at_first_energy(EquilibriumSampler const& samples, SetEnergy const& set) {
  double const kinetic = set.kinetic_capacity / set.capacity, E_0 = samples.energies().front();
  std::vector<double> T;
  for (std::size_t k = 0; k < samples.energies().size(); ++k)
    T.push_back(kinetic * samples.T_kin()[k] + (1 - kinetic) * samples.T_int()[k] -
                (samples.energies()[k] - E_0) / set.capacity);
  return T;
}

void add(cg::Estimate& estimate, double error) {
  estimate.se = std::hypot(estimate.se, error);
}

} // namespace

double pressure_slope(SimulationSettings const& settings) {
  auto const* const sdpd = std::get_if<Sdpd>(&settings.method);
  if (!sdpd)
    return std::pow(settings.spacing(), -3) / settings.K();
  constexpr double step = 1e-3;
  auto const P = [&](double T) {
    auto const of = [&](auto const& eos) { return fitting::state_from_temperature(eos, settings.rho, T).P; };
    return std::visit(of, sdpd->eos) / settings.units().pressure();
  };
  return (P(settings.T * (1 + step)) - P(settings.T * (1 - step))) / (2 * step);
}

double set_temperature_error(EquilibriumSampler const& samples, SetEnergy const& set) {
  auto const energies = samples.energies(), times = samples.times();
  require(energies.size() >= 32, "samples", energies.size(), "at least 32 are needed for errors");
  auto const T = cg::estimate_mean(temperature_at_first_energy(samples, set));
  double const parts = (times.back() - times.front()) / set.last_part;
  return std::hypot(T.se * std::sqrt(std::min(T.n_eff, parts)), gained_temperature(samples, set));
}

double gained_temperature(EquilibriumSampler const& samples, SetEnergy const& set) {
  auto const energies = samples.energies();
  double const mean = std::accumulate(energies.begin(), energies.end(), 0.0) / double(energies.size());
  return (mean - energies.front()) / set.capacity;
}

void add_error_of_set_energy(Equilibrium& means, double temperature_error, SetEnergy const& set) {
  add(means.T_kin, temperature_error);
  add(means.T_int, temperature_error);
  add(means.P, temperature_error * set.pressure_slope);
  add(means.P_i.mean, temperature_error * set.pressure_slope);
  add(means.eps.mean,
      temperature_error * (set.capacity - set.kinetic_capacity) / static_cast<double>(set.particles));
}

} // namespace mesobridge::sdpd
