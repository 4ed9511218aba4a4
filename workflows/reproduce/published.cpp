#include "workflows/reproduce/published.hpp"
#include "workflows/built_in.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <sstream>
#include <stdexcept>

namespace mesobridge::workflows {
namespace {

std::string comment_lines(std::string_view content) {
  std::string text;
  std::istringstream stream{std::string(content)};
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("#"))
      text += (text.empty() ? "" : " ") + line.substr(std::min<std::size_t>(2, line.size()));
  return text;
}

} // namespace

double PublishedTable::value(std::string_view row, std::string_view column) const {
  auto const& columns = table.header.cells;
  auto const c = std::ranges::find(columns, column);
  auto const r = std::ranges::find_if(table.rows, [&](auto const& of) { return of.cells.front() == row; });
  if (c == columns.end() || r == table.rows.end())
    throw std::logic_error(fmt::format("no published value for '{}', '{}'", row, column));
  return csv_number(table, *r, static_cast<std::size_t>(c - columns.begin()));
}

PublishedTable published(std::string_view name) {
  auto const files = built_in_tables();
  auto const found = std::ranges::find(files, name, &BuiltIn::name);
  if (found == files.end())
    throw std::logic_error(fmt::format("there is no published table '{}'", name));
  return {.source = comment_lines(found->content), .table = parse_csv(found->content, std::string(name))};
}

} // namespace mesobridge::workflows
