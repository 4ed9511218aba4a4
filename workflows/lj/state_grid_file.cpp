#include "workflows/lj/state_grid_file.hpp"
#include "md/error.hpp"
#include "workflows/summary.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

/// One column of the table: a number of a state point.
struct Column {
  std::string name;
  std::function<double&(cg::StatePoint&)> of;
};

std::vector<Column> const& columns() {
  using Point = cg::StatePoint;
  static std::vector<Column> const list = [] {
    std::vector<Column> columns{
        {"rho", [](Point& p) -> double& { return p.rho; }},
        {"T", [](Point& p) -> double& { return p.T; }},
        {"cov_UP", [](Point& p) -> double& { return p.cov_UP; }},
        {"tau_U", [](Point& p) -> double& { return p.tau_U; }},
        {"tau_P", [](Point& p) -> double& { return p.tau_P; }},
    };
    std::vector<std::pair<std::string, cg::Estimate Point::*>> const estimates{
        {"T_kin", &Point::T_kin}, {"U", &Point::U}, {"P", &Point::P}, {"c_v", &Point::c_v}};
    for (auto const& [name, member] : estimates) {
      columns.push_back({name, [member](Point& p) -> double& { return (p.*member).mean; }});
      columns.push_back({name + "_se", [member](Point& p) -> double& { return (p.*member).se; }});
      columns.push_back({name + "_n_eff", [member](Point& p) -> double& { return (p.*member).n_eff; }});
    }
    return columns;
  }();
  return list;
}

struct CountColumn {
  std::string name;
  std::function<std::int64_t(cg::StatePoint const&)> get;
  std::function<void(cg::StatePoint&, std::int64_t)> set;
};

std::vector<CountColumn> const& count_columns() {
  using Point = cg::StatePoint;
  static std::vector<CountColumn> const list{
      {"atoms", [](Point const& p) { return p.atoms; },
       [](Point& p, std::int64_t n) { p.atoms = static_cast<int>(n); }},
      {"samples", [](Point const& p) { return static_cast<std::int64_t>(p.samples); },
       [](Point& p, std::int64_t n) { p.samples = static_cast<std::size_t>(n); }},
      {"discarded", [](Point const& p) { return static_cast<std::int64_t>(p.discarded); },
       [](Point& p, std::int64_t n) { p.discarded = static_cast<std::size_t>(n); }},
  };
  return list;
}

std::string name_of(md::LjState state) {
  return fmt::format("rho* = {:.4g}, T* = {:.4g}", state.rho, state.T);
}

} // namespace

AnalysedGrid analyse_lj_grid(LjGridData const& data) {
  std::size_t longest = 0;
  for (auto const& series : data.series)
    longest = std::max(longest, series.samples.size());
  AnalysedGrid result;
  for (auto const& [state, samples] : data.series) {
    if (!data.complete && samples.size() < longest)
      result.left_out.push_back(
          fmt::format("{}: interrupted after {} of {} samples", name_of(state), samples.size(), longest));
    else
      result.grid.points.push_back(cg::analyse_state(state.rho, state.T, data.atoms, samples));
  }
  if (result.grid.points.empty())
    throw PhysicsError("no state of the grid has been sampled to its end");
  return result;
}

void write_state_grid(std::filesystem::path const& file, cg::StateGrid const& grid,
                      Provenance const& provenance) {
  Store store(file, Store::Mode::create);
  write_provenance(store, provenance);
  store.set_attribute("state_grid", "units", std::string("reduced Lennard-Jones, per atom"));
  auto points = grid.points;
  for (auto const& column : columns()) {
    std::vector<double> values;
    for (auto& point : points)
      values.push_back(column.of(point));
    if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
      throw PhysicsError(
          fmt::format("column '{}' of the state grid is not finite: it is not written", column.name));
    store.write("state_grid/" + column.name, values);
  }
  for (auto const& column : count_columns()) {
    std::vector<std::int64_t> values;
    for (auto const& point : points)
      values.push_back(column.get(point));
    store.write("state_grid/" + column.name, values);
  }
  store.close();
}

Json state_grid_json(cg::StateGrid const& grid) {
  Json states = Json::array();
  for (auto const& point : grid.points) {
    Json state{{"rho", point.rho}, {"T", point.T}};
    put(state, "T_kin", point.T_kin);
    put(state, "U", point.U);
    put(state, "P", point.P);
    put(state, "c_v", point.c_v);
    state["n_eff_U"] = point.U.n_eff;
    state["n_eff_P"] = point.P.n_eff;
    state["samples"] = point.samples;
    state["discarded"] = point.discarded;
    states.push_back(std::move(state));
  }
  return states;
}

cg::StateGrid read_state_grid(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  if (!store.is_group("state_grid"))
    throw InputError(fmt::format("'{}' holds no table of `cg state-grid`", file.string()));
  cg::StateGrid grid;
  auto const rows = store.rows("state_grid/rho");
  Expected const as_rho{.rows = rows, .least_rows = 1, .row_shape = Store::Shape{}};
  Expected counts = as_rho;
  counts.bounds = {.least = 0, .most = std::numeric_limits<int>::max()};
  for (auto const& column : columns()) {
    auto const values = store.read_doubles("state_grid/" + column.name, as_rho);
    grid.points.resize(rows);
    for (std::size_t i = 0; i < values.size(); ++i)
      column.of(grid.points[i]) = values[i];
  }
  for (auto const& column : count_columns()) {
    auto const values = store.read_integers("state_grid/" + column.name, counts);
    for (std::size_t i = 0; i < values.size(); ++i)
      column.set(grid.points[i], values[i]);
  }
  for (std::size_t i = 0; i < rows; ++i)
    if (!(grid.points[i].rho > 0) || !(grid.points[i].T > 0))
      throw InputError(fmt::format("'{}': row {} of state_grid has rho = {}, T = {}: both must be > 0",
                                   file.string(), i, grid.points[i].rho, grid.points[i].T));
  return grid;
}

} // namespace mesobridge::workflows
