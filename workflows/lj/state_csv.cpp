#include "workflows/lj/state_csv.hpp"
#include "md/error.hpp"
#include "workflows/csv_table.hpp"
#include "workflows/nearest.hpp"
#include <algorithm>
#include <fmt/ranges.h>
#include <optional>

namespace mesobridge::workflows {
namespace {

using ColumnNames = std::vector<std::string>;

ColumnNames const state_columns{"rho", "T", "U", "U_se", "U_res", "U_res_se", "P", "P_se", "cov_UP"};

[[noreturn]] void refuse_columns(CsvTable const& table, std::string const& why) {
  throw InputError(fmt::format("{}: {}; known are rho, T, U and U_se (or U_res and U_res_se, less 3/2 T), P, "
                               "P_se, cov_UP, all in Lennard-Jones units per atom",
                               table.header.origin, why));
}

/// Numbers of one row by the names of their columns.
class StateRow {
 public:
  StateRow(CsvTable const& table, CsvRow const& row) : table_(table), row_(row) {}
  bool has(std::string const& name) const { return column(name).has_value(); }
  double operator[](std::string const& name) const {
    auto const at = column(name);
    return at ? csv_number(table_, row_, *at) : 0;
  }
  double positive(std::string const& name) const {
    double const value = (*this)[name];
    require(value > 0, row_.origin + ": " + name, value, "must be > 0");
    return value;
  }

 private:
  std::optional<std::size_t> column(std::string const& name) const {
    auto const& names = table_.header.cells;
    auto const found = std::ranges::find(names, name);
    return found == names.end() ? std::nullopt : std::optional(std::size_t(found - names.begin()));
  }
  CsvTable const& table_;
  CsvRow const& row_;
};

void check_columns(CsvTable const& table) {
  for (auto const& name : table.header.cells)
    if (std::ranges::find(state_columns, name) == state_columns.end())
      refuse_columns(table, fmt::format("unknown column '{}'{}", name, did_you_mean(name, state_columns)));
  auto const has = [&](std::string const& name) {
    return std::ranges::find(table.header.cells, name) != table.header.cells.end();
  };
  for (char const* name : {"rho", "T", "P", "P_se"})
    if (!has(name))
      refuse_columns(table, fmt::format("no column '{}'", name));
  if (has("U") == has("U_res"))
    refuse_columns(table, "the energy must be there once, as U or as U_res");
  if (!has(has("U") ? "U_se" : "U_res_se"))
    refuse_columns(table, "no column with the standard error of the energy");
}

} // namespace

cg::StateGrid parse_state_csv(std::string const& text, std::string const& file) {
  auto const table = parse_csv(text, file);
  check_columns(table);
  cg::StateGrid grid;
  for (auto const& cells : table.rows) {
    StateRow const row(table, cells);
    cg::StatePoint point{.rho = row.positive("rho"), .T = row.positive("T"), .cov_UP = row["cov_UP"]};
    point.U = row.has("U") ? cg::Estimate{row["U"], row.positive("U_se")}
                           : cg::Estimate{row["U_res"] + 1.5 * point.T, row.positive("U_res_se")};
    point.P = {row["P"], row.positive("P_se")};
    grid.points.push_back(point);
  }
  return grid;
}

} // namespace mesobridge::workflows
