#include "fitting/fit_family.hpp"
#include <algorithm>
#include <limits>

namespace mesobridge::fitting {
namespace {

void widen(std::optional<double>& low, std::optional<double>& high, double value) {
  low = std::min(value, low.value_or(value));
  high = std::max(value, high.value_or(value));
}

std::optional<double> value_of(Observation const& observation, Quantity quantity) {
  for (auto const* list : {&observation.given, &observation.measured})
    for (auto const& datum : *list)
      if (datum.quantity == quantity)
        return datum.value;
  return std::nullopt;
}

/// The density that an observation says, by mass conservation if it gives both velocities.
std::optional<double> density_of(Observation const& observation) {
  if (auto const rho = value_of(observation, Quantity::rho))
    return rho;
  auto const v_P = value_of(observation, Quantity::v_P), v_S = value_of(observation, Quantity::v_S);
  if (observation.start && v_P && v_S && *v_S > *v_P)
    return observation.start->rho * *v_S / (*v_S - *v_P);
  return std::nullopt;
}

} // namespace

DataSummary summarise(std::span<Observation const> data) {
  DataSummary summary;
  std::optional<double> rho_min, rho_max, start;
  for (auto const& observation : data) {
    if (auto const rho = density_of(observation))
      widen(rho_min, rho_max, *rho);
    if (observation.start) {
      start = std::min(observation.start->rho, start.value_or(observation.start->rho));
      widen(rho_min, rho_max, observation.start->rho);
      if (observation.start->T)
        widen(summary.T_min, summary.T_max, *observation.start->T);
      summary.energies |= observation.start->e.has_value();
    }
    if (auto const T = value_of(observation, Quantity::T))
      widen(summary.T_min, summary.T_max, *T);
    summary.energies |= value_of(observation, Quantity::e).has_value();
  }
  require(rho_min.has_value(), "data", "no density", "at least one observation must say its density");
  summary.rho_min = *rho_min, summary.rho_max = *rho_max, summary.rho_start = start.value_or(*rho_min);
  return summary;
}

} // namespace mesobridge::fitting
