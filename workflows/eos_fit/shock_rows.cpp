#include "workflows/eos_fit/shock_rows.hpp"
#include "fitting/jump_conditions.hpp"
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::workflows {

using fitting::DataPath, fitting::Datum, fitting::Observation, fitting::Quantity, fitting::symbol;

namespace {

RowSplit split_state(RowNumbers const& numbers) {
  RowSplit split;
  for (auto const& [quantity, value] : numbers.values)
    split.measured.insert(quantity);
  split.given = {Quantity::rho, numbers.values.contains(Quantity::T) ? Quantity::T : Quantity::e};
  return split;
}

RowSplit split_shock(RowNumbers const& numbers) {
  auto const has = [&](Quantity quantity) { return numbers.values.contains(quantity); };
  bool const exact_rho = has(Quantity::rho) && !numbers.errors.contains(Quantity::rho);
  std::vector<Quantity> order{Quantity::rho, Quantity::v_P, Quantity::v_S, Quantity::P};
  if (exact_rho && has(Quantity::P) && numbers.errors.contains(Quantity::P))
    order = {Quantity::rho, Quantity::P};
  else if (has(Quantity::v_P) && has(Quantity::v_S))
    order = {Quantity::v_P, Quantity::v_S};
  std::erase_if(order, [&](Quantity quantity) { return !has(quantity); });
  RowSplit split;
  if (!order.empty())
    split.given.insert(order.front());
  if (order.size() > 1)
    split.measured.insert(order[1]);
  for (auto const quantity : {Quantity::T, Quantity::c_v, Quantity::sound_speed})
    if (has(quantity))
      split.measured.insert(quantity);
  return split;
}

Datum datum_of(Quantity quantity, RowNumbers const& numbers) {
  return {quantity, numbers.values.at(quantity), numbers.error(quantity).value_or(0)};
}

} // namespace

RowSplit split_of(DataPath path, RowNumbers const& numbers) {
  if (path == DataPath::hugoniot)
    return split_shock(numbers);
  RowSplit split = split_state(numbers);
  if (path == DataPath::isentrope)
    split.given = {Quantity::rho};
  if (path == DataPath::cj)
    split.given.clear();
  return split;
}

void check_jump(DataRow const& row, RowNumbers const& numbers, Observation const& shock,
                RowSplit const& split) {
  std::vector<Datum> pair, others;
  for (auto const quantity : {Quantity::rho, Quantity::P, Quantity::v_P, Quantity::v_S})
    if (numbers.values.contains(quantity)) {
      bool const used = split.given.contains(quantity) || split.measured.contains(quantity);
      (used ? pair : others).push_back(datum_of(quantity, numbers));
    }
  if (pair.size() != 2 || !shock.start)
    return;
  double const rho_0 = shock.start->rho;
  auto const P_0 = numbers.start_of(Quantity::P);
  auto const jump = fitting::jump_of(rho_0, P_0.value_or(0), pair[0], pair[1]);
  if (!(jump.rho > rho_0 && jump.v_S > jump.v_P && jump.v_P > 0 && std::isfinite(jump.rho * jump.v_S)))
    throw InputError(fmt::format(
        "{}: {} = {} and {} = {} are of no shock into density {}: by mass and momentum v_S "
        "must exceed v_P > 0, and rho rho0, and P P0",
        row.origin, symbol(pair[0].quantity), pair[0].value, symbol(pair[1].quantity), pair[1].value, rho_0));
  if (auto const wrong = fitting::contradiction(rho_0, P_0.value_or(0), pair[0], pair[1], others))
    throw InputError(fmt::format("{}: {} = {} contradicts {} = {} and {} = {}, by which it is {:.6g} (rho0 "
                                 "v_S = rho (v_S - v_P), P = P0 + "
                                 "rho0 v_S v_P, all in SI; rho0 = {}, P0 = {}{})",
                                 row.origin, symbol(wrong->stated.quantity), wrong->stated.value,
                                 symbol(pair[0].quantity), pair[0].value, symbol(pair[1].quantity),
                                 pair[1].value, wrong->by_jump, rho_0, P_0.value_or(0),
                                 P_0 ? "" : ", as no column P0 says another one"));
}

Observation sound_at_rest(Observation const& shock, RowNumbers const& numbers, RelativeErrors const& errors) {
  if (!numbers.values.contains(Quantity::v_S))
    throw InputError(fmt::format("{}: v_P = 0 without v_S says nothing", shock.origin));
  if (!shock.start || (shock.start->e && shock.start->P))
    throw InputError(
        fmt::format("{}: v_P = 0: the sound speed at rest needs rho0 and one of T0, e0, P0", shock.origin));
  double const rho_0 = shock.start->rho, v_S = numbers.values.at(Quantity::v_S);
  auto const P = numbers.value(Quantity::P), rho = numbers.value(Quantity::rho);
  double const P_0 = numbers.start_of(Quantity::P).value_or(0);
  constexpr double rounding = 5e-3;
  if (P && !(std::abs(*P - P_0) <= 5 * numbers.error(Quantity::P).value_or(0) + rounding * rho_0 * v_S * v_S))
    throw InputError(fmt::format("{}: v_P = 0, but P = {} is not P0 = {}", shock.origin, *P, P_0));
  if (rho && !(std::abs(*rho / rho_0 - 1) <= rounding))
    throw InputError(fmt::format("{}: v_P = 0, but rho = {} is not rho0 = {}", shock.origin, *rho, rho_0));
  Observation sound = shock;
  sound.path = DataPath::isentrope;
  sound.given = {{Quantity::rho, rho_0}};
  sound.measured = {
      {Quantity::sound_speed, v_S, error_of(Quantity::v_S, v_S, numbers, errors, shock.origin)}};
  return sound;
}

} // namespace mesobridge::workflows
