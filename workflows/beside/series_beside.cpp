#include "workflows/beside/series_beside.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include "workflows/store/store.hpp"
#include <algorithm>
#include <map>

namespace mesobridge::workflows {
namespace {

/// The table of a run's samples, column by column.
using Columns = std::map<std::string, std::vector<double>>;

Columns columns_of(std::filesystem::path const& run_file) {
  if (!std::filesystem::exists(run_file))
    return {};
  Store const store(run_file, Store::Mode::read);
  if (!store.contains("thermodynamics"))
    return {};
  auto const names = store.read_text_attributes("thermodynamics", "columns");
  auto const rows = store.read_doubles("thermodynamics", {.row_shape = Expected::Shape{names.size()}});
  Columns columns;
  for (std::size_t k = 0; k < rows.size(); ++k)
    columns[names[k % names.size()]].push_back(rows[k]);
  return columns;
}

/// The column of a quantity, whatever unit it has: "P" is "P_Pa" or "P".
std::string name_in(Columns const& columns, std::string const& quantity,
                    std::vector<std::string> const& units) {
  for (auto const& unit : units)
    if (columns.contains(quantity + unit))
      return quantity + unit;
  return {};
}

} // namespace

std::vector<Plot> series_beside(std::vector<RunNumbers> const& runs) {
  constexpr std::size_t most_points = 300;
  std::vector<Columns> all;
  for (auto const& run : runs)
    all.push_back(columns_of(run.folder / "run.h5"));
  std::vector<Plot> plots;
  for (auto const& [quantity, title] : {std::pair("T_kin", "Kinetic temperature"),
                                        {"T_int", "Internal temperature"},
                                        {"P", "Pressure"},
                                        {"rho", "Mean density"}}) {
    auto plot = one_panel(drawing_name(std::string("beside") + quantity), title, "", "");
    std::string first; // runs in other units have no place in the drawing
    for (std::size_t k = 0; k < runs.size(); ++k) {
      auto const name = name_in(all[k], quantity, {"", "_K", "_Pa", "_kg_m3"}),
                 time = name_in(all[k], "time", {"", "_s"});
      if (name.empty() || time.empty() || (!first.empty() && name != first))
        continue;
      first = name;
      auto const x = axis_of(time), y = axis_of(name);
      plot.x.label = x.label, plot.panels[0].y.label = y.label;
      plot.panels[0].series.push_back({.label = plain(runs[k].name),
                                       .x = thinned(scaled(all[k][time], x.factor), most_points),
                                       .y = thinned(scaled(all[k][name], y.factor), most_points),
                                       .style = SeriesStyle::lines,
                                       .colour = int(k)});
    }
    if (plot.panels[0].series.size() > 1)
      plots.push_back(std::move(plot));
  }
  return plots;
}

} // namespace mesobridge::workflows
