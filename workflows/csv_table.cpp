#include "workflows/csv_table.hpp"
#include "md/error.hpp"
#include "workflows/trimmed.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace mesobridge::workflows {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF", minus_sign = "\xE2\x88\x92";

/// One line without its end; takes it off the text.
std::string_view next_line(std::string_view& text) {
  auto const end = std::min(text.find_first_of("\r\n"), text.size());
  auto const line = text.substr(0, end);
  bool const two = text.substr(end, 2) == "\r\n";
  text.remove_prefix(std::min(text.size(), end + (two ? 2 : 1)));
  return line;
}

/// The line without what its quotes enclose.
std::string outside_quotes(std::string_view line) {
  std::string outside;
  bool quoted = false;
  for (char const c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (!quoted)
      outside += c;
  }
  return outside;
}

char separator_of(std::string_view header) {
  auto const text = outside_quotes(header);
  for (char const candidate : {';', '\t', ','})
    if (text.find(candidate) != text.npos)
      return candidate;
  return ' ';
}

class Cells {
 public:
  Cells(std::string_view line, char separator, std::string const& origin) : separator_(separator) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      char const c = line[i];
      if (c == '"' && quoted_ && line.substr(i + 1, 1) == "\"")
        cell_ += line[++i];
      else if (c == '"')
        quoted_ = !quoted_;
      else if (!quoted_ && separates(c))
        end_cell();
      else
        cell_ += c;
    }
    if (quoted_)
      throw InputError(fmt::format("{}: a quote is not closed on its line", origin));
    end_cell();
    if (separator_ == ' ') // blanks at the ends of the line separate nothing
      std::erase(cells_, "");
  }
  std::vector<std::string> take() { return std::move(cells_); }

 private:
  bool separates(char c) const { return separator_ == ' ' ? blanks.find(c) != blanks.npos : c == separator_; }
  void end_cell() {
    cells_.emplace_back(trimmed(cell_));
    cell_.clear();
  }

  char separator_;
  bool quoted_ = false;
  std::string cell_;
  std::vector<std::string> cells_;
};

bool all_empty(std::vector<std::string> const& cells) {
  return std::ranges::all_of(cells, &std::string::empty);
}

/// Takes off empty cells at the end that no name stands above.
void fit_to(std::vector<std::string>& cells, std::size_t columns) {
  while (cells.size() > columns && cells.back().empty())
    cells.pop_back();
}

void refuse_utf_16(std::string_view text, std::string const& file) {
  bool const marked = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  if (marked || text.substr(0, 1000).find('\0') != text.npos)
    throw InputError(fmt::format("{}: is UTF-16 or no text at all: save it as CSV in UTF-8", file));
}

void remove_unnamed(CsvTable& table) {
  auto& names = table.header.cells;
  for (std::size_t c = names.size(); c-- > 0;) {
    if (!names[c].empty())
      continue;
    for (auto& row : table.rows)
      if (!row.cells[c].empty())
        throw InputError(
            fmt::format("{}: '{}' stands in column {}, which has no name", row.origin, row.cells[c], c + 1));
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(c));
    for (auto& row : table.rows)
      row.cells.erase(row.cells.begin() + static_cast<std::ptrdiff_t>(c));
  }
}

void refuse_twice(CsvRow const& header) {
  auto names = header.cells;
  std::ranges::sort(names);
  if (auto const twice = std::ranges::adjacent_find(names); twice != names.end())
    throw InputError(fmt::format("{}: column '{}' stands there twice", header.origin, *twice));
}

/// The number that a whole text is, if it is one: with a decimal point; a plus, an exponent by D and a
/// typographic minus are understood.
std::optional<double> number_of(std::string text) {
  if (text.starts_with(minus_sign))
    text.replace(0, minus_sign.size(), "-");
  if (text.starts_with('+') && !text.starts_with("+-"))
    text.erase(0, 1);
  if (auto const exponent = text.find_first_of("dD"); exponent != text.npos)
    text[exponent] = 'e';
  if (auto const plus = text.find("e+"); plus != text.npos)
    text.erase(plus + 1, 1);
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Whether the cell is a number once its comma is read as a point.
bool has_decimal_comma(std::string const& cell) {
  if (std::ranges::count(cell, ',') != 1 || cell.find('.') != cell.npos)
    return false;
  auto point = cell;
  std::ranges::replace(point, ',', '.');
  return number_of(point).has_value();
}

bool has_decimal_point(std::string const& cell) {
  return cell.find('.') != cell.npos && number_of(cell).has_value();
}

/// Commas are decimal marks where they separate nothing; in a table that has numbers with points as well
/// nobody can tell.
void find_decimal_mark(CsvTable& table) {
  if (table.separator == ',')
    return;
  auto const first = [&](auto const& has) -> CsvRow const* {
    for (auto const& row : table.rows)
      if (std::ranges::any_of(row.cells, has))
        return &row;
    return nullptr;
  };
  auto const *const comma = first(has_decimal_comma), *const point = first(has_decimal_point);
  table.decimal_comma = comma != nullptr;
  if (comma && point)
    throw InputError(
        fmt::format("{}: has a number with a comma, but {} one with a point: what the comma means "
                    "cannot be told; write all decimal marks alike, and no thousands' separators",
                    comma->origin, point->origin));
}

} // namespace

CsvTable parse_csv(std::string_view text, std::string const& file) {
  if (text.starts_with(byte_order_mark))
    text.remove_prefix(byte_order_mark.size());
  refuse_utf_16(text, file);
  CsvTable table;
  for (int number = 1; !text.empty(); ++number) {
    auto const line = next_line(text);
    auto const bare = trimmed(line);
    if (bare.empty() || bare.starts_with('#'))
      continue;
    auto const origin = fmt::format("{}:{}", file, number);
    bool const is_header = table.header.cells.empty();
    if (is_header)
      table.separator = separator_of(line);
    auto cells = Cells(line, table.separator, origin).take();
    if (all_empty(cells))
      continue;
    if (is_header) {
      fit_to(cells, 0);
      table.header = {origin, std::move(cells)};
      continue;
    }
    auto const columns = table.header.cells.size();
    fit_to(cells, columns);
    if (cells.size() != columns)
      throw InputError(
          fmt::format("{}: {} cells, but the header names {} columns", origin, cells.size(), columns));
    table.rows.push_back({origin, std::move(cells)});
  }
  if (table.rows.empty())
    throw InputError(fmt::format(
        "{}: holds no data: a line that names the columns and lines of numbers are needed", file));
  if (std::ranges::all_of(table.header.cells, [](auto const& cell) { return number_of(cell).has_value(); }))
    throw InputError(
        fmt::format("{}: the first line that is no comment must name the columns, but holds numbers",
                    table.header.origin));
  remove_unnamed(table);
  refuse_twice(table.header);
  find_decimal_mark(table);
  return table;
}

double csv_number(CsvTable const& table, CsvRow const& row, std::size_t column, std::string_view what) {
  auto text = row.cells[column];
  if (table.decimal_comma)
    std::ranges::replace(text, ',', '.');
  auto const value = number_of(text);
  if (!value)
    throw InputError(fmt::format("{}: column '{}': '{}' {}", row.origin, table.header.cells[column],
                                 row.cells[column], what));
  return *value;
}

} // namespace mesobridge::workflows
