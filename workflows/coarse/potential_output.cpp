#include "workflows/coarse/potential_output.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/summary.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

std::vector<double> middles(double width, std::size_t count) {
  std::vector<double> r;
  for (std::size_t k = 0; k < count; ++k)
    r.push_back((double(k) + 0.5) * width);
  return r;
}

Series line(std::string label, double width, std::vector<double> const& y,
            SeriesStyle style = SeriesStyle::lines) {
  return {.label = std::move(label), .x = middles(width, y.size()), .y = y, .y_error = {}, .style = style};
}

/// Without the core, where nothing was seen: at most so many k_B T.
Series shown_potential(std::string label, cg::PairPotential const& potential, double most,
                       SeriesStyle style) {
  auto series = line(std::move(label), potential.width, potential.u, style);
  while (series.y.size() > 2 && series.y.front() > most)
    series.x.erase(series.x.begin()), series.y.erase(series.y.begin());
  return series;
}

Table trials_table(CoarseStructure const& structure, std::vector<PotentialTrial> const& trials) {
  Table table{.header = {"trial", "difference of g(r)", "P"}};
  for (std::size_t k = 0; k < trials.size(); ++k)
    table.rows.push_back(
        {std::to_string(k + 1), number_text(trials[k].difference, 3), with_error_text(trials[k].P)});
  table.caption = "Difference: int (g - g_target)^2 r^2 dr/int g_target^2 r^2 dr.";
  if (structure.P)
    table.caption += fmt::format(" Pressure of the molecules: {}.", number_text(*structure.P, 5));
  return table;
}

} // namespace

std::string potential_csv(cg::PairPotential const& potential) {
  auto const& u = potential.u;
  std::string text = fmt::format("r,u\n0,{:.10g}\n", u[0] + (u[0] - u[1]) / 8);
  for (std::size_t k = 0; k < u.size(); ++k)
    text += fmt::format("{:.10g},{:.10g}\n", potential.r(k), u[k]);
  return text + fmt::format("{:.10g},0\n", potential.cutoff());
}

Json potential_json(CoarseStructure const& structure, std::vector<PotentialTrial> const& trials) {
  auto const& found = best(trials);
  Json json{{"density", structure.density},
            {"mass", structure.mass},
            {"kT", structure.kT},
            {"cutoff", found.potential.cutoff()},
            {"g_difference", found.difference}};
  put(json, "P", found.P);
  if (structure.P)
    json["P_target"] = *structure.P;
  for (auto const& trial : trials)
    json["trials"].push_back({{"g_difference", trial.difference}, {"P", trial.P.mean}, {"P_se", trial.P.se}});
  json["r"] = middles(found.g.width, found.g.g.size());
  json["g"] = found.g.g, json["g_target"] = structure.g.g, json["u"] = found.potential.u;
  return json;
}

std::string potential_text(CoarseStructure const& structure, std::vector<PotentialTrial> const& trials) {
  auto const& found = best(trials);
  auto text = fmt::format("{} trials; difference of g(r) {:.2g}, first {:.2g}\nP       {}", trials.size(),
                          found.difference, trials.front().difference, with_error_text(found.P));
  return text +
         (structure.P ? fmt::format("  (of the molecules: {})\n", number_text(*structure.P, 5)) : "\n");
}

Report potential_report(CoarseStructure const& structure, std::vector<PotentialTrial> const& trials,
                        std::string const& name, std::string const& units) {
  auto const& found = best(trials);
  auto u = one_panel("potential", "Pair potential", "r", "u/k_BT");
  auto const in_kT = [&](cg::PairPotential potential) {
    for (double& value : potential.u)
      value /= structure.kT;
    return potential;
  };
  u.panels[0].series = {
      shown_potential("found", in_kT(found.potential), 15, SeriesStyle::lines),
      shown_potential("first: of mean force", in_kT(trials.front().potential), 15, SeriesStyle::dashes)};
  u.panels[0].level_lines = {0};
  auto g = one_panel("structure", "Radial distribution", "r", "g(r)", {1});
  g.panels[0].series = {
      line("molecules", structure.g.width, structure.g.g, SeriesStyle::points),
      line("particles", found.g.width, found.g.g),
      line("particles, first potential", found.g.width, trials.front().g.g, SeriesStyle::dashes)};
  Report report;
  report.title = "Pair potential of " + name;
  report.lead = fmt::format("In units of {}: particles with this potential have the radial distribution of "
                            "the molecules' centres of mass "
                            "but for {:.2g} of its square; that with the potential of mean force, {:.2g}.",
                            units, found.difference, trials.front().difference);
  report.sections = {{"Potential and structure",
                      {Figure{{draw_svg(u), draw_svg(g)},
                              "Where the molecules never come, the potential goes on as a + b r^2."}}},
                     {"Trials", {trials_table(structure, trials)}}};
  return report;
}

} // namespace mesobridge::workflows
