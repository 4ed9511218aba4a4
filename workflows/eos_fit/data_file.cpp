#include "workflows/eos_fit/data_file.hpp"
#include "fitting/jump_conditions.hpp"
#include "md/error.hpp"
#include "workflows/eos_fit/data_table.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

namespace mesobridge::workflows {
namespace {

using fitting::DataPath;
using fitting::Datum;
using fitting::Observation;
using fitting::Quantity;
using fitting::StartState;
using fitting::symbol;

/// A row's numbers in SI by what they are.
struct Numbers {
  std::map<Quantity, double> values, errors, start, start_errors;
  double P_e_correlation = 0;

  std::optional<double> start_of(Quantity quantity) const {
    auto const found = start.find(quantity);
    return found == start.end() ? std::nullopt : std::optional(found->second);
  }
};

Numbers numbers_of(DataRow const& row, std::map<std::string, DataColumn> const& columns) {
  Numbers numbers;
  for (auto const& [name, number] : row.numbers) {
    auto const& column = columns.at(name);
    double const value = number * column.factor;
    bool fresh = true;
    switch (column.role) {
    case DataColumn::Role::value:
      fresh = numbers.values.emplace(column.quantity, value).second;
      break;
    case DataColumn::Role::standard_error:
      fresh = numbers.errors.emplace(column.quantity, value).second;
      break;
    case DataColumn::Role::start:
      fresh = numbers.start.emplace(column.quantity, value).second;
      break;
    case DataColumn::Role::start_error:
      fresh = numbers.start_errors.emplace(column.quantity, value).second;
      break;
    case DataColumn::Role::P_e_correlation:
      numbers.P_e_correlation = number;
      break;
    }
    if (!fresh)
      throw InputError(
          fmt::format("{}: column '{}': {} is given twice", row.origin, name, symbol(column.quantity)));
  }
  return numbers;
}

DataPath path_of(DataRow const& row, Numbers const& numbers) {
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

std::optional<StartState> start_of(Numbers const& numbers, DataPath path) {
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

std::optional<double> found_in(std::map<Quantity, double> const& numbers, Quantity quantity) {
  auto const found = numbers.find(quantity);
  return found == numbers.end() ? std::nullopt : std::optional(found->second);
}

/// What a shock's start says of the pressure of matter at rest; nothing where P0 itself is the start.
std::optional<Observation::AtRest> at_rest(Numbers const& numbers, std::optional<StartState> const& start,
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
                             .P_se = found_in(numbers.start_errors, Quantity::P),
                             .rho_se = found_in(numbers.start_errors, Quantity::rho)};
}

/// What stands in a row and is not counted.
struct Unused {
  std::set<std::string> dependent; ///< follows from what is counted
  std::set<std::string> dropped;
};

/// Columns of the start that a row does not use.
void note_unused_start(Numbers const& numbers, Observation const& observation,
                       std::set<std::string>& unused) {
  if (observation.start && observation.start->T && numbers.start.contains(Quantity::e))
    unused.insert("e0 (beside T0)");
  for (auto const& [quantity, se] : numbers.start_errors)
    if (!observation.at_rest || (quantity != Quantity::P && quantity != Quantity::rho))
      unused.insert(fmt::format("{}0_se", symbol(quantity)));
}

/// What says where the row's state is, and what was measured there.
struct Split {
  std::set<Quantity> given, measured;
};

Split split_state(Numbers const& numbers) {
  Split split;
  for (auto const& [quantity, value] : numbers.values)
    split.measured.insert(quantity);
  split.given = {Quantity::rho, numbers.values.contains(Quantity::T) ? Quantity::T : Quantity::e};
  return split;
}

Split split_shock(Numbers const& numbers) {
  auto const has = [&](Quantity quantity) { return numbers.values.contains(quantity); };
  bool const exact_rho = has(Quantity::rho) && !numbers.errors.contains(Quantity::rho);
  std::vector<Quantity> order{Quantity::rho, Quantity::v_P, Quantity::v_S, Quantity::P};
  if (exact_rho && has(Quantity::P) && numbers.errors.contains(Quantity::P))
    order = {Quantity::rho, Quantity::P};
  else if (has(Quantity::v_P) && has(Quantity::v_S))
    order = {Quantity::v_P, Quantity::v_S};
  std::erase_if(order, [&](Quantity quantity) { return !has(quantity); });
  Split split;
  if (!order.empty())
    split.given.insert(order.front());
  if (order.size() > 1)
    split.measured.insert(order[1]);
  for (auto const quantity : {Quantity::T, Quantity::c_v, Quantity::sound_speed})
    if (has(quantity))
      split.measured.insert(quantity);
  return split;
}

Split split_of(DataPath path, Numbers const& numbers) {
  if (path == DataPath::hugoniot)
    return split_shock(numbers);
  Split split = split_state(numbers);
  if (path == DataPath::isentrope)
    split.given = {Quantity::rho};
  if (path == DataPath::cj)
    split.given.clear();
  return split;
}

double error_of(Quantity quantity, double value, Numbers const& numbers, RelativeErrors const& relative,
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

Datum datum_of(Quantity quantity, Numbers const& numbers) {
  return {quantity, numbers.values.at(quantity), found_in(numbers.errors, quantity).value_or(0)};
}

/// Refuses a row whose quantities contradict each other by conservation of mass and momentum.
void check_jump(DataRow const& row, Numbers const& numbers, Observation const& shock, Split const& split) {
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

/// A shock of no strength runs at the speed of sound of matter at rest.
Observation sound_at_rest(Observation const& shock, Numbers const& numbers, RelativeErrors const& errors) {
  if (!numbers.values.contains(Quantity::v_S))
    throw InputError(fmt::format("{}: v_P = 0 without v_S says nothing", shock.origin));
  if (!shock.start || (shock.start->e && shock.start->P))
    throw InputError(
        fmt::format("{}: v_P = 0: the sound speed at rest needs rho0 and one of T0, e0, P0", shock.origin));
  double const rho_0 = shock.start->rho, v_S = numbers.values.at(Quantity::v_S);
  auto const P = found_in(numbers.values, Quantity::P), rho = found_in(numbers.values, Quantity::rho);
  double const P_0 = numbers.start_of(Quantity::P).value_or(0);
  constexpr double rounding = 5e-3;
  if (P && !(std::abs(*P - P_0) <=
             5 * found_in(numbers.errors, Quantity::P).value_or(0) + rounding * rho_0 * v_S * v_S))
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

Observation observation_of(DataRow const& row, Numbers const& numbers, RelativeErrors const& errors,
                           Unused& unused) {
  auto const path = path_of(row, numbers);
  if (auto const v_P = found_in(numbers.values, Quantity::v_P); path == DataPath::hugoniot && v_P && *v_P < 0)
    throw InputError(fmt::format("{}: v_P = {}: must be >= 0", row.origin, *v_P));
  auto const split = split_of(path, numbers);
  Observation observation{.path = path,
                          .start = start_of(numbers, path),
                          .P_e_correlation = numbers.P_e_correlation,
                          .origin = row.origin};
  if (path == DataPath::hugoniot)
    observation.at_rest = at_rest(numbers, observation.start, row.origin);
  note_unused_start(numbers, observation, unused.dropped);
  if (path == DataPath::hugoniot && found_in(numbers.values, Quantity::v_P) == 0.0) {
    observation = sound_at_rest(observation, numbers, errors);
    for (auto const quantity : {Quantity::T, Quantity::e, Quantity::c_v, Quantity::sound_speed})
      if (numbers.values.contains(quantity))
        unused.dropped.insert(fmt::format("{} (of rows with v_P = 0)", symbol(quantity)));
    check(observation);
    return observation;
  }
  for (auto const& [quantity, value] : numbers.values) {
    if (split.given.contains(quantity)) {
      auto const se = numbers.errors.find(quantity);
      observation.given.push_back({quantity, value, se == numbers.errors.end() ? 0 : se->second});
    } else if (split.measured.contains(quantity)) {
      observation.measured.push_back(
          {quantity, value, error_of(quantity, value, numbers, errors, row.origin)});
    } else {
      unused.dependent.insert(std::string(symbol(quantity)));
    }
  }
  check(observation);
  if (path == DataPath::hugoniot)
    check_jump(row, numbers, observation, split);
  return observation;
}

bool is_hdf5(std::filesystem::path const& file) {
  return file.extension() == ".h5" || file.extension() == ".hdf5";
}

} // namespace

EosData read_eos_data(std::filesystem::path const& file, RelativeErrors const& errors) {
  auto const table =
      is_hdf5(file) ? read_hdf5_table(file) : parse_csv_table(read_text_file(file), file.string());
  EosData data;
  Unused unused;
  for (auto const& row : table.rows)
    data.observations.push_back(observation_of(row, numbers_of(row, table.columns), errors, unused));
  if (!unused.dropped.empty())
    data.notes.push_back(fmt::format("{}: not used: {}", file.string(), fmt::join(unused.dropped, ", ")));
  if (!unused.dependent.empty())
    data.notes.push_back(fmt::format(
        "{}: {} of shocked states follow from the other quantities, which they do not contradict: not "
        "counted twice",
        file.string(), fmt::join(unused.dependent, ", ")));
  if (!table.not_read.empty())
    data.notes.push_back(fmt::format("{}: not read: {}", file.string(), fmt::join(table.not_read, ", ")));
  return data;
}

void add_relative_error(RelativeErrors& errors, std::string const& text) {
  auto const equals = text.find('=');
  auto const digits = text.substr(equals == text.npos ? 0 : equals + 1);
  double value = 0;
  auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  bool const number = error == std::errc() && end == digits.data() + digits.size();
  require(number && value > 0 && value < 1, "--relative-error", text,
          "must be a fraction between 0 and 1, or QUANTITY=fraction");
  if (equals == text.npos) {
    errors.all = value;
    return;
  }
  using enum Quantity;
  for (auto const quantity : {rho, T, e, P, c_v, sound_speed, v_P, v_S})
    if (text.substr(0, equals) == symbol(quantity)) {
      errors.of[quantity] = value;
      return;
    }
  throw InputError(
      fmt::format("--relative-error = {}: the quantity must be rho, T, e, P, c_v, sound_speed, v_P or "
                  "v_S",
                  text));
}

} // namespace mesobridge::workflows
