#include "workflows/eos_fit/data_table.hpp"
#include "md/error.hpp"
#include "workflows/csv_table.hpp"
#include "workflows/store/store.hpp"
#include <cmath>

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
    throw InputError(fmt::format("'{}': {} groups hold a dataset rho_kg_m3 or rho0_kg_m3; exactly one must",
                                 store.file().string(), found.size()));
  return found.front();
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
