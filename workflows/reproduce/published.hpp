#pragma once
#include "workflows/csv_table.hpp"

namespace mesobridge::workflows {

/// Printed values: one of the files of workflows/data, built into the program.
struct PublishedTable {
  std::string source; ///< its comment lines: what it is and where it stands
  CsvTable table;

  /// The number in that column of the row whose first cell is `row`. Throws std::logic_error.
  double value(std::string_view row, std::string_view column) const;
};

/// The table of a file's name, "thesis-table-4.1.csv". Throws std::logic_error for a name that is not there.
PublishedTable published(std::string_view name);

} // namespace mesobridge::workflows
