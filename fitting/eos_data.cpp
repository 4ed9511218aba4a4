#include "fitting/eos_data.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::fitting {
namespace {

[[noreturn]] void refuse(Observation const& observation, std::string const& what) {
  throw InputError(fmt::format("{}: {}", observation.origin, what));
}

bool positive_only(Quantity quantity) {
  return quantity != Quantity::e && quantity != Quantity::P && quantity != Quantity::v_P;
}

void check_datum(Observation const& observation, Datum const& datum, bool measured) {
  auto const name = symbol(datum.quantity);
  if (!std::isfinite(datum.value) || (positive_only(datum.quantity) && !(datum.value > 0)))
    refuse(observation, fmt::format("{} = {}: must be {}", name, datum.value,
                                    positive_only(datum.quantity) ? "> 0" : "finite"));
  if (!std::isfinite(datum.se) || !(datum.se >= 0) || (measured && datum.se == 0))
    refuse(observation, fmt::format("standard error of {} = {}: must be {} and finite", name, datum.se,
                                    measured ? "> 0" : ">= 0"));
}

void check_start(Observation const& observation) {
  if (!observation.start)
    refuse(observation, "a shock, an isentrope and a detonation need the density of their start (rho0)");
  auto const& [rho, T, e, P] = *observation.start;
  auto const finite = [](std::optional<double> x) { return !x || std::isfinite(*x); };
  if (!(rho > 0 && std::isfinite(rho)))
    refuse(observation, fmt::format("rho0 = {}: must be > 0 and finite", rho));
  if (!finite(T) || !finite(e) || !finite(P) || (T && !(*T > 0)))
    refuse(observation, "T0 must be > 0, e0 and P0 finite");
  int const count = int{T.has_value()} + int{e.has_value()} + int{P.has_value()};
  bool const foreign = e && P && !T;
  if (observation.path == DataPath::cj && !foreign)
    refuse(observation,
           "a detonation needs rho0, e0 and P0: the reactant's energy on the scale of its products");
  if (count != 1 && !(foreign && observation.path != DataPath::isentrope))
    refuse(observation,
           "the start needs one of T0, e0, P0 beside rho0 (a shock may have e0 and P0 together)");
}

void check_given(Observation const& observation) {
  auto const given = [&](Quantity quantity) {
    return std::ranges::count(observation.given, quantity, &Datum::quantity) == 1;
  };
  std::size_t const count = observation.given.size();
  switch (observation.path) {
  case DataPath::state:
    if (count != 2 || !given(Quantity::rho) || !(given(Quantity::T) || given(Quantity::e)))
      refuse(observation, "a state needs rho and T, or rho and e");
    return;
  case DataPath::hugoniot:
    if (count != 1 ||
        !(given(Quantity::rho) || given(Quantity::P) || given(Quantity::v_P) || given(Quantity::v_S)))
      refuse(observation, "a shocked state needs one of rho, v_P, v_S, P that says how strong the shock is");
    return;
  case DataPath::isentrope:
    if (count != 1 || !given(Quantity::rho))
      refuse(observation, "a state on an isentrope needs rho");
    return;
  case DataPath::cj:
    if (count != 0)
      refuse(observation, "a Chapman-Jouguet state is given by its start alone");
  }
}

/// Standard deviation of all measured values of a quantity; 0 if there is only one.
double spread(std::vector<Observation> const& data, Quantity quantity) {
  std::vector<double> values;
  for (auto const& observation : data)
    for (auto const& datum : observation.measured)
      if (datum.quantity == quantity)
        values.push_back(datum.value);
  return values.size() < 2 ? 0 : gsl_stats_sd(values.data(), 1, values.size());
}

} // namespace

std::string_view symbol(Quantity quantity) {
  constexpr std::array<std::string_view, 8> in_order{"rho", "T",           "e",   "P",
                                                     "c_v", "sound_speed", "v_P", "v_S"};
  return in_order.at(static_cast<std::size_t>(quantity));
}

void add_systematic_errors(std::vector<Observation>& data, double fraction) {
  require(fraction >= 0 && fraction < 1, "systematic relative error", fraction, "must be in [0, 1)");
  double const of_P = spread(data, Quantity::P), of_e = spread(data, Quantity::e);
  for (auto& observation : data)
    for (auto& datum : observation.measured) {
      double const size = datum.quantity == Quantity::P   ? std::max(std::abs(datum.value), of_P)
                          : datum.quantity == Quantity::e ? of_e
                                                          : std::abs(datum.value);
      datum.systematic = fraction * size;
    }
}

void check(Observation const& observation) {
  if (observation.path != DataPath::state)
    check_start(observation);
  check_given(observation);
  for (auto const& datum : observation.given)
    check_datum(observation, datum, false);
  for (auto const& datum : observation.measured)
    check_datum(observation, datum, true);
  if (observation.measured.empty())
    refuse(observation, "nothing was measured here");
  if (!(std::abs(observation.P_e_correlation) < 1))
    refuse(observation,
           fmt::format("P_e_correlation = {}: must lie between -1 and 1", observation.P_e_correlation));
}

} // namespace mesobridge::fitting
