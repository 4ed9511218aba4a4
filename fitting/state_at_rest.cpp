#include "fitting/state_at_rest.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::fitting {
namespace {

constexpr double atmosphere = 1e5;

bool near(double a, double b) {
  return std::abs(a - b) <= 1e-6 * std::abs(b);
}

/// Whether a measured pressure of the state is among the data.
bool is_known(std::vector<Observation> const& data, Observation const& rest) {
  return std::ranges::any_of(data, [&](Observation const& observation) {
    return observation.path == DataPath::state &&
           std::ranges::count(observation.measured, Quantity::P, &Datum::quantity) &&
           std::ranges::all_of(rest.given, [&](Datum const& given) {
             auto const same = std::ranges::find(observation.given, given.quantity, &Datum::quantity);
             return same != observation.given.end() && near(same->value, given.value);
           });
  });
}

Observation state_at_rest(Observation const& shock) {
  auto const& start = *shock.start;
  auto const& rest = *shock.at_rest;
  double const default_se = rest.P_se ? 0 : error_of_initial_density * start.rho;
  return {.path = DataPath::state,
          .start = std::nullopt,
          .given = {{Quantity::rho, start.rho, rest.rho_se.value_or(default_se)},
                    start.T ? Datum{Quantity::T, *start.T} : Datum{Quantity::e, start.e.value()}},
          .measured = {{Quantity::P, rest.P, rest.P_se.value_or(atmosphere)}},
          .origin = shock.origin + " at rest"};
}

std::string sentence(Observation const& state, Observation::AtRest const& rest) {
  auto const& rho = state.given[0];
  auto const& second = state.given[1];
  return fmt::format(
      "{}: P({} kg/m^3, {} {}) = {} Pa{} counts as a datum, with a standard error of {:.3g} Pa and "
      "of {:.3g} kg/m^3 in the density{}",
      state.origin, rho.value, second.value, second.quantity == Quantity::T ? "K" : "J/kg", rest.P,
      rest.P_is_given ? "" : " (no P0 is given)", state.measured[0].se, rho.se,
      rest.P_se || rest.rho_se ? "" : "; columns rho0_se and P0_se say other ones");
}

} // namespace

std::vector<std::string> add_states_at_rest(std::vector<Observation>& data) {
  std::vector<std::string> sentences;
  auto const given = data; // the additions are appended to it
  for (auto const& shock : given) {
    if (!shock.at_rest)
      continue;
    auto const state = state_at_rest(shock);
    if (is_known(data, state))
      continue;
    sentences.push_back(sentence(state, *shock.at_rest));
    data.push_back(state);
  }
  return sentences;
}

} // namespace mesobridge::fitting
