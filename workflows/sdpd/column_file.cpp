#include "workflows/sdpd/column_file.hpp"
#include "md/error.hpp"
#include "workflows/nearest.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <charconv>
#include <sstream>

namespace mesobridge::workflows {
namespace {

std::string trimmed(std::string const& text) {
  auto const first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

std::vector<std::string> cells(std::string const& line) {
  std::vector<std::string> found;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');)
    found.push_back(trimmed(cell));
  if (line.ends_with(','))
    found.emplace_back();
  return found;
}

double number(std::string const& cell, std::string const& place, std::string const& column) {
  double value = 0;
  auto const [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw InputError(fmt::format("{}: {} = '{}': must be a finite number", place, column, cell));
  return value;
}

void check_header(std::vector<std::string> const& header, std::string const& place,
                  std::vector<std::string> const& required, std::vector<std::string> known) {
  known.insert(known.begin(), required.begin(), required.end());
  for (auto const& name : header)
    if (std::ranges::find(known, name) == known.end() || std::ranges::count(header, name) > 1)
      throw InputError(fmt::format("{}: column '{}' is unknown or there twice{}; known: {}", place, name,
                                   did_you_mean(name, known), fmt::join(known, ", ")));
  for (auto const& name : required)
    if (std::ranges::find(header, name) == header.end())
      throw InputError(
          fmt::format("{}: column '{}' is missing; known: {}", place, name, fmt::join(known, ", ")));
}

} // namespace

std::map<std::string, std::vector<double>> read_columns(std::filesystem::path const& file,
                                                        std::vector<std::string> const& required,
                                                        std::vector<std::string> const& optional) {
  std::istringstream text(read_text_file(file));
  std::map<std::string, std::vector<double>> columns;
  std::vector<std::string> header;
  std::size_t line_number = 0;
  for (std::string line; std::getline(text, line);) {
    ++line_number;
    if (trimmed(line).empty() || trimmed(line).starts_with('#'))
      continue;
    auto const place = fmt::format("{}:{}", file.string(), line_number);
    auto const row = cells(line);
    if (header.empty()) {
      header = row;
      check_header(header, place, required, optional);
      continue;
    }
    if (row.size() != header.size())
      throw InputError(fmt::format("{}: {} cells, but {} columns", place, row.size(), header.size()));
    for (std::size_t c = 0; c < row.size(); ++c)
      columns[header[c]].push_back(number(row[c], place, header[c]));
  }
  if (columns.empty())
    throw InputError(fmt::format("{}: holds no numbers", file.string()));
  return columns;
}

} // namespace mesobridge::workflows
