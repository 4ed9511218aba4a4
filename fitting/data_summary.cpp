#include "fitting/data_summary.hpp"
#include "md/error.hpp"
#include <algorithm>

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

void note_detonation(Observation const& observation, DataSummary& summary) {
  if (observation.path != DataPath::cj)
    return;
  summary.e_explosive = observation.start ? observation.start->e.value_or(0) : 0;
  for (auto const& datum : observation.measured) {
    if (datum.quantity == Quantity::v_S)
      summary.D_CJ = datum.value;
    if (datum.quantity == Quantity::P)
      summary.P_CJ = datum.value;
  }
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
    note_detonation(observation, summary);
  }
  require(rho_min.has_value(), "data", "no density", "at least one observation must say its density");
  summary.rho_min = *rho_min, summary.rho_max = *rho_max, summary.v_min = 1 / *rho_max;
  summary.rho_start = start.value_or(*rho_min);
  summary.T_coldest = summary.T_min.value_or(summary.T_coldest);
  return summary;
}

} // namespace mesobridge::fitting
