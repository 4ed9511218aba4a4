#include "workflows/eos_fit/data_file.hpp"
#include "md/error.hpp"
#include "workflows/eos_fit/shock_rows.hpp"
#include "workflows/text_file.hpp"
#include <charconv>
#include <cmath>

namespace mesobridge::workflows {
namespace {

using fitting::DataPath;
using fitting::Observation;
using fitting::Quantity;
using fitting::symbol;

/// What stands in a row and is not counted.
struct Unused {
  std::set<std::string> dependent; ///< follows from what is counted
  std::set<std::string> dropped;
};

/// Columns of the start that a row does not use.
void note_unused_start(RowNumbers const& numbers, Observation const& observation,
                       std::set<std::string>& unused) {
  if (observation.start && observation.start->T && numbers.start.contains(Quantity::e))
    unused.insert("e0 (beside T0)");
  for (auto const& [quantity, se] : numbers.start_errors)
    if (!observation.at_rest || (quantity != Quantity::P && quantity != Quantity::rho))
      unused.insert(fmt::format("{}0_se", symbol(quantity)));
}

Observation observation_of(DataRow const& row, RowNumbers const& numbers, RelativeErrors const& errors,
                           Unused& unused) {
  auto const path = path_of(row, numbers);
  if (auto const v_P = numbers.value(Quantity::v_P); path == DataPath::hugoniot && v_P && *v_P < 0)
    throw InputError(fmt::format("{}: v_P = {}: must be >= 0", row.origin, *v_P));
  auto const split = split_of(path, numbers);
  Observation observation{.path = path,
                          .start = start_of(numbers, path),
                          .P_e_correlation = numbers.P_e_correlation,
                          .origin = row.origin};
  if (path == DataPath::hugoniot)
    observation.at_rest = at_rest(numbers, observation.start, row.origin);
  note_unused_start(numbers, observation, unused.dropped);
  if (path == DataPath::hugoniot && numbers.value(Quantity::v_P) == 0.0) {
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
