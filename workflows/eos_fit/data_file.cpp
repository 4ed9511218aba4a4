#include "workflows/eos_fit/data_file.hpp"
#include "md/error.hpp"
#include "workflows/eos_fit/data_table.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <charconv>
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
  std::map<Quantity, double> values, errors, start;
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
  if (start.T) // it says all; e0 and P0 beside it are the model's to tell
    start.e = start.P = std::nullopt;
  return start;
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

Observation observation_of(DataRow const& row, Numbers const& numbers, RelativeErrors const& errors,
                           std::set<std::string>& unused) {
  auto const path = path_of(row, numbers);
  auto const split = split_of(path, numbers);
  Observation observation{.path = path,
                          .start = start_of(numbers, path),
                          .P_e_correlation = numbers.P_e_correlation,
                          .origin = row.origin};
  for (auto const& [quantity, value] : numbers.values) {
    if (split.given.contains(quantity)) {
      auto const se = numbers.errors.find(quantity);
      observation.given.push_back({quantity, value, se == numbers.errors.end() ? 0 : se->second});
    } else if (split.measured.contains(quantity)) {
      observation.measured.push_back(
          {quantity, value, error_of(quantity, value, numbers, errors, row.origin)});
    } else {
      unused.insert(std::string(symbol(quantity)));
    }
  }
  check(observation);
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
  std::set<std::string> unused;
  for (auto const& row : table.rows)
    data.observations.push_back(observation_of(row, numbers_of(row, table.columns), errors, unused));
  if (!unused.empty())
    data.notes.push_back(
        fmt::format("{}: {} of shocked states follow from the other quantities: not counted twice",
                    file.string(), fmt::join(unused, ", ")));
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
