#include "workflows/sdpd/column_file.hpp"
#include "md/error.hpp"
#include "workflows/csv_table.hpp"
#include "workflows/nearest.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// The unit at the end of a column's name; empty for reduced ones.
std::string_view unit_of(std::string_view name) {
  for (std::string_view const unit : {"_kg_s", "_W_K", "_m", "_J", "_N"})
    if (name.ends_with(unit))
      return unit;
  return "";
}

/// Known columns that have the word's own unit: another one would be off by a factor.
std::vector<std::string> of_same_unit(std::string const& word, std::vector<std::string> const& known) {
  std::vector<std::string> same;
  for (auto const& name : known)
    if (auto const unit = unit_of(name); unit.empty() ? word.size() == 1 : word.ends_with(unit))
      same.push_back(name);
  return same;
}

void check_header(CsvRow const& header, std::vector<std::string> const& required,
                  std::vector<std::string> known) {
  known.insert(known.begin(), required.begin(), required.end());
  auto const& names = header.cells;
  for (auto const& name : names)
    if (std::ranges::find(known, name) == known.end())
      throw InputError(fmt::format("{}: column '{}' is unknown{}; known: {}", header.origin, name,
                                   did_you_mean(name, of_same_unit(name, known)), fmt::join(known, ", ")));
  for (auto const& name : required)
    if (std::ranges::find(names, name) == names.end())
      throw InputError(
          fmt::format("{}: column '{}' is missing; known: {}", header.origin, name, fmt::join(known, ", ")));
}

} // namespace

std::map<std::string, std::vector<double>> read_columns(std::filesystem::path const& file,
                                                        std::vector<std::string> const& required,
                                                        std::vector<std::string> const& optional) {
  auto const table = parse_csv(read_text_file(file), file.string());
  check_header(table.header, required, optional);
  std::map<std::string, std::vector<double>> columns;
  for (auto const& row : table.rows)
    for (std::size_t c = 0; c < row.cells.size(); ++c)
      columns[table.header.cells[c]].push_back(csv_number(table, row, c));
  return columns;
}

} // namespace mesobridge::workflows
