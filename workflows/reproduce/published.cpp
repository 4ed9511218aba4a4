#include "workflows/reproduce/published.hpp"
#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace mesobridge::workflows {
namespace {

constexpr std::pair<std::string_view, std::string_view> files[] = {
#include "generated/published_data.inc"
};

std::vector<std::string> cells(std::string const& line) {
  std::vector<std::string> result;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');)
    result.push_back(cell);
  return result;
}

} // namespace

double PublishedTable::value(std::string_view row, std::string_view column) const {
  auto const c = std::find(columns.begin(), columns.end(), column);
  auto const r = std::find_if(rows.begin(), rows.end(), [&](auto const& of) { return of.at(0) == row; });
  if (c == columns.end() || r == rows.end())
    throw std::logic_error(fmt::format("no published value for '{}', '{}'", row, column));
  auto const& text = r->at(static_cast<std::size_t>(c - columns.begin()));
  double number = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), number).ec != std::errc())
    throw std::logic_error(fmt::format("published value '{}' is no number", text));
  return number;
}

PublishedTable published(std::string_view name) {
  auto const found =
      std::find_if(std::begin(files), std::end(files), [&](auto const& f) { return f.first == name; });
  if (found == std::end(files))
    throw std::logic_error(fmt::format("there is no published table '{}'", name));
  PublishedTable table;
  std::istringstream stream{std::string(found->second)};
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("#"))
      table.source += (table.source.empty() ? "" : " ") + line.substr(std::min<std::size_t>(2, line.size()));
    else if (table.columns.empty())
      table.columns = cells(line);
    else if (!line.empty())
      table.rows.push_back(cells(line));
  }
  return table;
}

} // namespace mesobridge::workflows
