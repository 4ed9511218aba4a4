#include "workflows/coarse/exchange_output.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/summary.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

void add_point(Series& series, double x, cg::Estimate const& y) {
  series.x.push_back(x), series.y.push_back(y.mean), series.y_error.push_back(y.se);
}

Figure decay_figure(cg::EnergyExchange const& found) {
  Plot plot{
      .name = "decay", .title = "Internal energy of one molecule", .x = {.label = "t"}, .panels = {Panel{}}};
  Series own{.label = ""};
  for (std::size_t lag = 0; lag < found.lag.size(); ++lag)
    add_point(own, found.lag[lag], found.own[lag]);
  plot.panels[0].series = {own};
  plot.panels[0].y = {.label = "⟨δU(t)δU⟩/⟨δU^2⟩", .min = 0};
  return {{draw_svg(plot)}, "Without what molecules far from each other have in common."};
}

Figure passing_figure(cg::EnergyExchange const& found) {
  Plot plot{.name = "passing",
            .title = "Energy that has come from a neighbour",
            .x = {.label = "t"},
            .panels = {Panel{}}};
  std::size_t const step = std::max<std::size_t>(1, found.bins.size() / 6);
  for (std::size_t k = 0; k < found.bins.size(); k += step) {
    Series bin{.label = fmt::format("r = {:.2f}", found.bins[k].r)};
    for (std::size_t lag = 0; lag < found.lag.size(); ++lag)
      add_point(bin, found.lag[lag], found.bins[k].together[lag]);
    plot.panels[0].series.push_back(std::move(bin));
  }
  plot.panels[0].y.label = "⟨δU_i(t)δU_j⟩";
  plot.panels[0].level_lines = {0};
  return {{draw_svg(plot)},
          fmt::format("Of molecules i and j at the distance r at time 0. Their slopes at short times are "
                      "those of parabolas over "
                      "{:.3g} ... {:.3g}.",
                      found.from, found.to)};
}

Figure conduction_figure(cg::EnergyExchange const& found, std::vector<ConductionRow> const& rows,
                         cg::ConductionTable const& table) {
  Plot plot{.name = "conduction", .title = "Weight of conduction", .x = {.label = "r"}, .panels = {Panel{}}};
  Series flow{
      .label = "flow of energy",
  },
      kappa{.label = "κ: the same and what friction takes"};
  for (auto const& bin : found.bins)
    add_point(flow, bin.r, bin.flow);
  for (auto const& row : rows)
    add_point(kappa, row.r, row.kappa);
  Series const line{
      .label = "table", .x = table.r, .y = table.kappa, .y_error = {}, .style = SeriesStyle::lines};
  plot.panels[0].series = {flow, kappa, line};
  plot.panels[0].y.label = "κ(r)";
  plot.panels[0].level_lines = {0};
  return {{draw_svg(plot)}, ""};
}

} // namespace

std::string conduction_csv(cg::ConductionTable const& table) {
  std::string text = "r,kappa\n";
  for (std::size_t k = 0; k < table.r.size(); ++k)
    text += fmt::format("{:.10g},{:.10g}\n", table.r[k], table.kappa[k]);
  return text;
}

Json exchange_json(cg::EnergyExchange const& found, std::vector<ConductionRow> const& rows,
                   cg::ConductionTable const& table) {
  Json json;
  put(json, "variance", found.variance);
  if (found.decay)
    put(json, "decay_time", *found.decay);
  put(json, "loss", found.loss);
  put(json, "gain_of_neighbours", found.gain);
  json["lag"] = found.lag;
  for (auto const& own : found.own) {
    json["own"].push_back(own.mean);
    json["own_se"].push_back(own.se);
  }
  for (auto const& bin : found.bins) {
    Json of_bin{{"r", bin.r}, {"neighbours", bin.neighbours}};
    put(of_bin, "flow", bin.flow);
    for (auto const& at : bin.together) {
      of_bin["together"].push_back(at.mean);
      of_bin["together_se"].push_back(at.se);
    }
    json["bins"].push_back(std::move(of_bin));
  }
  for (auto const& row : rows) {
    json["r"].push_back(row.r);
    json["kappa"].push_back(row.kappa.mean);
    json["kappa_se"].push_back(row.kappa.se);
  }
  json["table"] = {{"r", table.r}, {"kappa", table.kappa}};
  return json;
}

std::string exchange_text(cg::EnergyExchange const& found) {
  auto text = fmt::format("variance of U         {}\n", with_error_text(found.variance));
  text += found.decay ? fmt::format("U has lost 1 - 1/e    after {}\n", with_error_text(*found.decay))
                      : fmt::format("U has not lost 1 - 1/e by the longest lag, {:g}\n", found.lag.back());
  return text + fmt::format("loss of one molecule  {}\ngain of neighbours    {}\n",
                            with_error_text(found.loss), with_error_text(found.gain));
}

Report exchange_report(cg::EnergyExchange const& found, std::vector<ConductionRow> const& rows,
                       cg::ConductionTable const& table, std::string const& name, std::string const& units) {
  Report report;
  report.title = "Exchange of energy in " + name;
  report.lead =
      fmt::format("In units of {}: of what a molecule loses, {} a unit of time, its neighbours gain {}.",
                  units, with_error_text(found.loss), with_error_text(found.gain));
  report.sections = {{"Decay", {decay_figure(found)}},
                     {"Exchange", {passing_figure(found), conduction_figure(found, rows, table)}}};
  return report;
}

} // namespace mesobridge::workflows
