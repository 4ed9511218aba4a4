#include "workflows/eos_fit/row_numbers.hpp"
#include "md/error.hpp"
#include <cmath>

namespace mesobridge::workflows {

using fitting::DataPath, fitting::Observation, fitting::Quantity, fitting::StartState, fitting::symbol;

namespace {

std::optional<double> found_in(std::map<Quantity, double> const& numbers, Quantity quantity) {
  auto const found = numbers.find(quantity);
  return found == numbers.end() ? std::nullopt : std::optional(found->second);
}

std::map<Quantity, double>& numbers_of_role(RowNumbers& numbers, DataColumn::Role role) {
  switch (role) {
  case DataColumn::Role::standard_error:
    return numbers.errors;
  case DataColumn::Role::start:
    return numbers.start;
  case DataColumn::Role::start_error:
    return numbers.start_errors;
  default:
    return numbers.values;
  }
}

} // namespace

std::optional<double> RowNumbers::value(Quantity quantity) const {
  return found_in(values, quantity);
}
std::optional<double> RowNumbers::error(Quantity quantity) const {
  return found_in(errors, quantity);
}
std::optional<double> RowNumbers::start_of(Quantity quantity) const {
  return found_in(start, quantity);
}
std::optional<double> RowNumbers::start_error(Quantity quantity) const {
  return found_in(start_errors, quantity);
}

RowNumbers numbers_of(DataRow const& row, std::map<std::string, DataColumn> const& columns) {
  RowNumbers numbers;
  for (auto const& [name, number] : row.numbers) {
    auto const& column = columns.at(name);
    double const value = number * column.factor;
    if (column.role == DataColumn::Role::P_e_correlation) {
      numbers.P_e_correlation = number;
      continue;
    }
    if (!numbers_of_role(numbers, column.role).emplace(column.quantity, value).second)
      throw InputError(
          fmt::format("{}: column '{}': {} is given twice", row.origin, name, symbol(column.quantity)));
  }
  return numbers;
}

DataPath path_of(DataRow const& row, RowNumbers const& numbers) {
  static std::map<std::string, DataPath> const kinds{{"state", DataPath::state},
                                                     {"hugoniot", DataPath::hugoniot},
                                                     {"isentrope", DataPath::isentrope},
                                                     {"cj", DataPath::cj}};
  if (row.kind.empty())
    return numbers.start.empty() ? DataPath::state : DataPath::hugoniot;
  auto const found = kinds.find(row.kind);
  if (found == kinds.end())
    throw InputError(fmt::format("{}: column 'kind': '{}' must be state, hugoniot, isentrope or cj",
                                 row.origin, row.kind));
  return found->second;
}

std::optional<StartState> start_of(RowNumbers const& numbers, DataPath path) {
  auto const rho = numbers.start_of(Quantity::rho);
  if (path == DataPath::state || !rho)
    return std::nullopt;
  StartState start{.rho = *rho,
                   .T = numbers.start_of(Quantity::T),
                   .e = numbers.start_of(Quantity::e),
                   .P = numbers.start_of(Quantity::P)};
  if (start.T) // it says all; P0 beside it is a datum
    start.e = start.P = std::nullopt;
  return start;
}

std::optional<Observation::AtRest> at_rest(RowNumbers const& numbers, std::optional<StartState> const& start,
                                           std::string const& origin) {
  if (!start || start->P || !(start->T || start->e))
    return std::nullopt;
  for (auto const& [quantity, se] : numbers.start_errors)
    if (!(se > 0))
      throw InputError(
          fmt::format("{}: standard error of {}0 = {}: must be > 0", origin, symbol(quantity), se));
  auto const P = numbers.start_of(Quantity::P);
  return Observation::AtRest{.P = P.value_or(0),
                             .P_is_given = P.has_value(),
                             .P_se = numbers.start_error(Quantity::P),
                             .rho_se = numbers.start_error(Quantity::rho)};
}

double error_of(Quantity quantity, double value, RowNumbers const& numbers, RelativeErrors const& relative,
                std::string const& origin) {
  if (auto const found = numbers.errors.find(quantity); found != numbers.errors.end())
    return found->second;
  auto const found = relative.of.find(quantity);
  auto const fraction = found != relative.of.end() ? std::optional(found->second) : relative.all;
  if (!fraction)
    throw InputError(fmt::format("{}: {} has no standard error: add a column {}_se_(unit), or give "
                                 "--relative-error {}=0.01",
                                 origin, symbol(quantity), symbol(quantity), symbol(quantity)));
  return *fraction * std::abs(value);
}

} // namespace mesobridge::workflows
