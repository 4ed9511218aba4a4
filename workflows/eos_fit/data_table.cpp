#include "workflows/eos_fit/data_table.hpp"
#include "md/error.hpp"
#include "workflows/csv_table.hpp"
#include "workflows/store/store.hpp"
#include <cmath>
#include <limits>

namespace mesobridge::workflows {
namespace {

void add_column(DataTable& table, std::string const& name, std::string const& origin) {
  if (is_remark(name) || name == "kind")
    return;
  if (is_derived(name))
    return table.not_read.push_back(name);
  try {
    table.columns.emplace(name, parse_data_column(name));
  } catch (InputError const& error) {
    throw InputError(fmt::format("{}: {}", origin, error.what()));
  }
}

DataRow row_of(CsvTable const& table, CsvRow const& cells) {
  DataRow row{.origin = cells.origin, .kind = {}, .numbers = {}};
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    auto const& name = table.header.cells[i];
    if (name == "kind")
      row.kind = cells.cells[i];
    else if (!cells.cells[i].empty() && !is_remark(name) && !is_derived(name))
      row.numbers.emplace(name, csv_number(table, cells, i, "must be a finite number, or empty"));
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
    throw InputError(
        fmt::format("'{}': {} groups hold a dataset rho_kg_m3 or rho0_kg_m3; exactly one must (or the "
                    "file itself as `eos table` writes it, in SI: rho_kg_m3, T_K and tables over both)",
                    store.file().string(), found.size()));
  return found.front();
}

/// The names that are columns; others go to `not_read`.
void take_names(DataTable& table, std::vector<std::string> const& names) {
  for (auto const& name : names) {
    try {
      table.columns.emplace(name, parse_data_column(name));
    } catch (InputError const&) {
      table.not_read.push_back(name);
    }
  }
}

/// Adds a column to the rows; NaN is an empty cell.
void add_values(DataTable& table, std::string const& name, std::vector<double> const& values,
                std::string const& dataset) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isinf(values[i]))
      throw InputError(
          fmt::format("{}[{}] = {}: must be a finite number, or NaN for none", dataset, i, values[i]));
    if (!std::isnan(values[i]))
      table.rows[i].numbers.emplace(name, values[i]);
  }
}

constexpr char const *grid_density = "rho_kg_m3", *grid_temperature = "T_K", *grid_speed = "sound_speed_m_s",
                     *grid_squared_speed = "sound_speed_squared_m2_s2";

bool is_grid(Store const& store) {
  return store.contains(grid_density) && !store.is_group(grid_density) && store.contains(grid_temperature);
}

/// Sound speeds, where the table has their squares; states without one have none.
std::vector<double> roots(std::vector<double> squares) {
  for (double& value : squares)
    value = value >= 0 ? std::sqrt(value) : std::numeric_limits<double>::quiet_NaN();
  return squares;
}

/// Tables over densities and temperatures, as `eos table` writes them: a row for each state.
DataTable read_grid(Store const& store) {
  Expected const axis{.least_rows = 1, .row_shape = Store::Shape{}};
  auto const rho = store.read_doubles(grid_density, axis), T = store.read_doubles(grid_temperature, axis);
  DataTable table;
  std::vector<std::string> names;
  for (auto const& name : store.list("/"))
    if (!store.is_group(name) && name != "model")
      names.push_back(name);
  take_names(table, names);
  for (std::size_t i = 0; i < rho.size(); ++i)
    for (std::size_t j = 0; j < T.size(); ++j)
      table.rows.push_back({.origin = fmt::format("{}: [{}][{}]", store.file().string(), i, j),
                            .kind = {},
                            .numbers = {{grid_density, rho[i]}, {grid_temperature, T[j]}}});
  auto const values_of = [&](std::string const& name) {
    return store.read_doubles(
        name, {.rows = rho.size(), .row_shape = Store::Shape{T.size()}, .bounds = {.finite = false}});
  };
  auto const dataset = [&](std::string const& name) {
    return fmt::format("'{}': dataset '{}'", store.file().string(), name);
  };
  for (auto const& [name, column] : table.columns)
    if (name != grid_density && name != grid_temperature)
      add_values(table, name, values_of(name), dataset(name));
  if (store.contains(grid_squared_speed) && !table.columns.contains(grid_speed)) {
    table.columns.emplace(grid_speed, parse_data_column(grid_speed));
    add_values(table, grid_speed, roots(values_of(grid_squared_speed)), dataset(grid_squared_speed));
    std::erase(table.not_read, grid_squared_speed);
  }
  return table;
}

} // namespace

DataTable parse_csv_table(std::string const& text, std::string const& file) {
  auto const csv = parse_csv(text, file);
  DataTable table;
  for (auto const& name : csv.header.cells)
    add_column(table, name, csv.header.origin);
  for (auto const& row : csv.rows)
    table.rows.push_back(row_of(csv, row));
  return table;
}

DataTable read_hdf5_table(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  if (is_grid(store))
    return read_grid(store);
  auto const group = data_group(store);
  DataTable table;
  take_names(table, store.list(group));
  for (auto const& [name, column] : table.columns) {
    auto const values = store.read_doubles(
        group + "/" + name, {.least_rows = 1, .row_shape = Store::Shape{}, .bounds = {.finite = false}});
    if (table.rows.empty())
      for (std::size_t i = 0; i < values.size(); ++i)
        table.rows.push_back(
            {.origin = fmt::format("{}: {}[{}]", file.string(), group, i), .kind = {}, .numbers = {}});
    if (values.size() != table.rows.size())
      throw InputError(fmt::format("'{}': dataset '{}/{}' has another length than the others", file.string(),
                                   group, name));
    add_values(table, name, values, fmt::format("'{}': dataset '{}/{}'", file.string(), group, name));
  }
  return table;
}

} // namespace mesobridge::workflows
