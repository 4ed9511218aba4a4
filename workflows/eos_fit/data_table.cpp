#include "workflows/eos_fit/data_table.hpp"
#include "md/error.hpp"
#include "workflows/store/store.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace mesobridge::workflows {
namespace {

std::string trimmed(std::string_view text) {
  auto const first = text.find_first_not_of(" \t\r");
  return first == text.npos ? ""
                            : std::string(text.substr(first, text.find_last_not_of(" \t\r") + 1 - first));
}

std::vector<std::string> cells_of(std::string const& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0;;) {
    auto const end = line.find(',', begin);
    cells.push_back(trimmed(std::string_view(line).substr(begin, end - begin)));
    if (end == line.npos)
      return cells;
    begin = end + 1;
  }
}

double number(std::string const& cell, std::string const& origin, std::string const& column) {
  double value = 0;
  auto const [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw InputError(
        fmt::format("{}: column '{}': '{}' must be a finite number, or empty", origin, column, cell));
  return value;
}

void add_column(DataTable& table, std::string const& name, std::string const& origin) {
  if (is_remark(name) || name == "kind")
    return;
  try {
    table.columns.emplace(name, parse_data_column(name));
  } catch (InputError const& error) {
    throw InputError(fmt::format("{}: {}", origin, error.what()));
  }
}

void check_header(std::vector<std::string> names, std::string const& origin) {
  std::ranges::sort(names);
  if (auto const twice = std::ranges::adjacent_find(names); twice != names.end())
    throw InputError(fmt::format("{}: column '{}' stands there twice", origin, *twice));
}

DataRow row_of(std::vector<std::string> const& cells, std::vector<std::string> const& header,
               std::string const& origin) {
  if (cells.size() != header.size())
    throw InputError(
        fmt::format("{}: {} cells, but the header names {} columns", origin, cells.size(), header.size()));
  DataRow row{.origin = origin, .kind = {}, .numbers = {}};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (header[i] == "kind")
      row.kind = cells[i];
    else if (!cells[i].empty() && !is_remark(header[i]))
      row.numbers.emplace(header[i], number(cells[i], origin, header[i]));
  }
  return row;
}

/// The group whose datasets are columns: the only one with a density.
std::string data_group(Store const& store) {
  std::vector<std::string> found;
  for (auto const& group : store.list("/"))
    for (auto const* const density : {"rho_kg_m3", "rho0_kg_m3"})
      if (store.contains(group + "/" + density) && (found.empty() || found.back() != group))
        found.push_back(group);
  if (found.size() != 1)
    throw InputError(fmt::format("'{}': {} groups hold a dataset rho_kg_m3 or rho0_kg_m3; exactly one must",
                                 store.file().string(), found.size()));
  return found.front();
}

} // namespace

DataTable parse_csv_table(std::string const& text, std::string const& file) {
  DataTable table;
  std::vector<std::string> header;
  std::istringstream stream(text);
  std::string line;
  for (int number_of_line = 1; std::getline(stream, line); ++number_of_line) {
    auto const bare = trimmed(line);
    if (bare.empty() || bare.starts_with('#'))
      continue;
    auto const origin = fmt::format("{}:{}", file, number_of_line);
    auto const cells = cells_of(bare);
    if (header.empty()) {
      header = cells;
      check_header(header, origin);
      for (auto const& name : header)
        add_column(table, name, origin);
    } else {
      table.rows.push_back(row_of(cells, header, origin));
    }
  }
  if (table.rows.empty())
    throw InputError(fmt::format(
        "{}: holds no data: a line that names the columns and lines of numbers are needed", file));
  return table;
}

DataTable read_hdf5_table(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  auto const group = data_group(store);
  DataTable table;
  for (auto const& name : store.list(group)) {
    try {
      table.columns.emplace(name, parse_data_column(name));
    } catch (InputError const&) {
      table.not_read.push_back(name);
    }
  }
  for (auto const& [name, column] : table.columns) {
    auto const values = store.read_doubles(
        group + "/" + name,
        {.least_rows = 1, .row_shape = Store::Shape{}, .bounds = {.finite = false}}); // NaN: an empty cell
    if (table.rows.empty())
      table.rows.resize(values.size());
    if (values.size() != table.rows.size())
      throw InputError(fmt::format("'{}': dataset '{}/{}' has another length than the others", file.string(),
                                   group, name));
    for (std::size_t i = 0; i < values.size(); ++i) {
      table.rows[i].origin = fmt::format("{}: {}[{}]", file.string(), group, i);
      if (std::isinf(values[i]))
        throw InputError(
            fmt::format("'{}': dataset '{}/{}'[{}] = {}: must be a finite number, or NaN for none",
                        file.string(), group, name, i, values[i]));
      if (!std::isnan(values[i]))
        table.rows[i].numbers.emplace(name, values[i]);
    }
  }
  return table;
}

} // namespace mesobridge::workflows
