#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace mesobridge::workflows {

/// A line of a CSV file with its cells, without blanks about them and without quotes.
struct CsvRow {
  std::string origin; ///< "tin.csv:12"
  std::vector<std::string> cells;
};

/// A CSV file: one line that names the columns, then a line a row, each with as many cells.
struct CsvTable {
  CsvRow header; ///< names are not empty, and there once
  std::vector<CsvRow> rows;
  char separator = ',';       ///< a blank stands for any number of blanks and tabs
  bool decimal_comma = false; ///< numbers are written 8,93
};

/// Reads what spreadsheets and programs write: with a byte-order mark or without, lines that end in LF, CRLF
/// or CR; cells between commas, semicolons, tabs or blanks (the header line tells which), with or without
/// quotes, with decimal commas where commas do not separate. Lines that begin with # and those without any
/// content are left out, so are empty cells beyond the last name and columns without name and content.
///
/// Throws InputError with file and line: for UTF-16, quotes that do not close, rows of another length, names
/// that are there twice, cells under no name, numbers with both decimal marks; and for files without rows.
CsvTable parse_csv(std::string_view text, std::string const& file);

/// A cell as a number: 293, +293, -1.5e3, 1.5D3, and 8,93 in tables with decimal commas. Throws InputError
/// that names row, column and cell unless it is one finite number; `what` says what is allowed.
double csv_number(CsvTable const& table, CsvRow const& row, std::size_t column,
                  std::string_view what = "must be a finite number");

} // namespace mesobridge::workflows
