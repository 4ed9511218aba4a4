#include "workflows/beside/beside_report.hpp"
#include "workflows/beside/series_beside.hpp"
#include "workflows/report/check.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/terminal.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// One quantity in all runs that have it.
struct RowBeside {
  std::string key;
  std::vector<cg::Estimate const*> values; ///< one a run; null: it has none
  std::size_t first = 0;                   ///< that has it

  /// Of a run's value from the first, in standard errors of both; nothing to say for the first.
  std::optional<double> deviation_of(std::size_t run) const {
    if (!values[run] || run == first)
      return std::nullopt;
    double const apart = deviation({key, *values[run], *values[first]});
    return std::isfinite(apart) ? std::optional(apart) : std::nullopt;
  }
  /// Two numbers without an error that are not the same.
  bool differs_exactly(std::size_t run) const {
    return values[run] && run != first && values[run]->se == 0 && values[first]->se == 0 &&
           values[run]->mean != values[first]->mean;
  }
};

/// In the order of the first run; what only others have follows.
std::vector<RowBeside> rows_of(std::vector<RunNumbers> const& runs) {
  std::vector<RowBeside> rows;
  for (auto const& run : runs)
    for (auto const& [key, value] : run.numbers) {
      if (std::ranges::find(rows, key, &RowBeside::key) != rows.end())
        continue;
      RowBeside row{.key = key};
      for (auto const& other : runs)
        row.values.push_back(other.number(key));
      row.first = std::size_t(std::ranges::find_if(row.values, [](auto const* v) { return v != nullptr; }) -
                              row.values.begin());
      rows.push_back(std::move(row));
    }
  return rows;
}

std::string deviation_text(std::optional<double> deviation) {
  return deviation ? fmt::format("{:+.1f}", *deviation) : "";
}

Table numbers_table(std::vector<RunNumbers> const& runs) {
  Table table{.header = {"quantity"},
              .caption = "Behind each run but the first: how far it is from the first, in standard errors of "
                         "their difference, which takes runs as independent."};
  for (std::size_t k = 0; k < runs.size(); ++k) {
    table.header.push_back(runs[k].name);
    if (k > 0)
      table.header.emplace_back("apart [se]");
  }
  for (auto const& row : rows_of(runs)) {
    std::vector<std::string> cells{row.key};
    for (std::size_t k = 0; k < runs.size(); ++k) {
      cells.push_back(row.values[k] ? with_error_text(*row.values[k]) : "");
      if (k > 0)
        cells.push_back(row.differs_exactly(k) ? "differs" : deviation_text(row.deviation_of(k)));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Keys of the scenes that are not the same in all runs that have a scene.
Table scenes_table(std::vector<RunNumbers> const& runs) {
  Table table{.header = {"key"}, .caption = "What the scenes say otherwise; all other keys are the same."};
  std::vector<std::string> names;
  for (auto const& run : runs) {
    table.header.push_back(run.name);
    for (auto const& [key, value] : run.keys)
      if (std::ranges::find(names, key) == names.end())
        names.push_back(key);
  }
  for (auto const& name : names) {
    std::vector<std::string> cells{name};
    for (auto const& run : runs) {
      auto const found = std::ranges::find(run.keys, name, [](auto const& one) { return one.first; });
      cells.push_back(found == run.keys.end() ? "" : found->second);
    }
    if (std::ranges::any_of(cells.begin() + 2, cells.end(), [&](auto const& c) { return c != cells[1]; }))
      table.rows.push_back(std::move(cells));
  }
  return table;
}

std::vector<VerdictLine> lines_of(std::vector<RunNumbers> const& runs) {
  std::vector<VerdictLine> lines;
  auto const rows = rows_of(runs);
  for (std::size_t k = 1; k < runs.size(); ++k) {
    std::vector<Comparison> comparisons;
    for (auto const& row : rows)
      if (row.first == 0 && row.deviation_of(k))
        comparisons.push_back({row.key, *row.values[k], *row.values[0]});
    if (!comparisons.empty())
      lines.push_back(noted_line(fmt::format("{} beside {}", runs[k].name, runs.front().name), comparisons));
  }
  return lines;
}

} // namespace

Report beside_report(std::vector<RunNumbers> const& runs) {
  Report report{.title = fmt::format("{} runs beside each other", runs.size()),
                .lead = "Each number with its standard error as the runs' summaries have it, differences in "
                        "standard errors of both; independent runs of the same state are about one apart, "
                        "and one number in twenty two or more.",
                .verdicts = lines_of(runs),
                .sections = {},
                .provenance = {}};
  report.sections.push_back({"Numbers", {numbers_table(runs)}});
  if (auto const plots = series_beside(runs); !plots.empty()) {
    Figure figure{{}, "Means of neighbouring samples where there are many."};
    for (auto const& plot : plots)
      figure.svgs.push_back(draw_svg(plot));
    report.sections.push_back({"In time", {figure}});
  }
  if (auto const scenes = scenes_table(runs); !scenes.rows.empty())
    report.sections.push_back({"Scenes", {scenes}});
  return report;
}

Json beside_runs_json(std::vector<RunNumbers> const& runs) {
  Json json{{"runs", Json::array()}, {"numbers", Json::object()}};
  for (auto const& run : runs)
    json["runs"].push_back(run.name);
  for (auto const& row : rows_of(runs)) {
    auto& list = json["numbers"][row.key] = Json::array();
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (!row.values[k]) {
        list.push_back(nullptr);
        continue;
      }
      Json one{{"value", row.values[k]->mean}, {"se", row.values[k]->se}};
      if (auto const apart = row.deviation_of(k))
        one["deviation"] = *apart;
      list.push_back(std::move(one));
    }
  }
  return json;
}

std::string beside_runs_text(std::vector<RunNumbers> const& runs) {
  auto const table = numbers_table(runs);
  std::vector<std::size_t> widths(table.header.size(), 0);
  auto const rows = [&] {
    auto all = table.rows;
    all.insert(all.begin(), table.header);
    return all;
  }();
  for (auto const& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c)
      widths[c] = std::max(widths[c], display_width(row[c]));
  std::string text;
  for (auto const& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += row[c] + std::string(widths[c] - display_width(row[c]) + 2, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

} // namespace mesobridge::workflows
