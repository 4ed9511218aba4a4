#pragma once
#include "workflows/eos_fit/data_columns.hpp"
#include <filesystem>
#include <map>
#include <optional>

namespace mesobridge::workflows {

/// One row of a data file by its columns; what is missing was empty.
struct DataRow {
  std::string origin; ///< "tin.csv:12"
  std::string kind;   ///< text of the column `kind`
  std::map<std::string, double> numbers;
};

/// A data file before its rows are understood. Columns with remarks are left out.
struct DataTable {
  std::map<std::string, DataColumn> columns;
  std::vector<DataRow> rows;
  std::vector<std::string> not_read; ///< columns that are no data of this kind
};

/// Throws InputError with file, line and column.
DataTable parse_csv_table(std::string const& text, std::string const& file);
/// One dataset a column in one group; or what `eos table` writes, tables over rho_kg_m3 and T_K.
DataTable read_hdf5_table(std::filesystem::path const& file);

} // namespace mesobridge::workflows
