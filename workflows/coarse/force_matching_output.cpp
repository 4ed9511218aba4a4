#include "workflows/coarse/force_matching_output.hpp"
#include "workflows/coarse/plot_parts.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/summary.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

constexpr double most_growth = 1.5; // of errors with blocks twice as long

/// The bins that hold pairs.
std::vector<std::size_t> seen(cg::MatchedForce const& found) {
  std::vector<std::size_t> bins;
  for (std::size_t bin = 0; bin < found.f.size(); ++bin)
    if (found.r(bin) > found.first)
      bins.push_back(bin);
  return bins;
}

Series over_r(std::string label, cg::MatchedForce const& found, std::vector<cg::Estimate> const& of,
              SeriesStyle style, int colour) {
  std::vector<double> r;
  std::vector<cg::Estimate> values;
  for (auto const bin : seen(found))
    r.push_back(found.r(bin)), values.push_back(of[bin]);
  return estimates(std::move(label), r, values, style, colour);
}

Series other(PotentialBeside const& beside, std::vector<double> const& y) {
  return {.label = "beside", .x = beside.r, .y = y, .y_error = {}, .style = SeriesStyle::lines, .colour = 1};
}

Figure matched_figure(ForceMatch const& match) {
  auto f = one_panel("force", "Pair force", "r", "f", {0}),
       u = one_panel("potential", "Pair potential", "r", "u", {0});
  f.panels[0].series = {over_r("pairs", match.found, match.found.f, SeriesStyle::points, 0)};
  u.panels[0].series = {over_r("pairs", match.found, match.found.u, SeriesStyle::points, 0)};
  if (auto const& beside = match.beside) {
    f.panels[0].series.push_back(other(*beside, beside->f));
    u.panels[0].series.push_back(other(*beside, beside->u));
  }
  f.panels[0].series.push_back(
      over_r("with all others'", match.found, match.found.mean_force, SeriesStyle::points, 2));
  std::string caption = fmt::format(
      "With one standard error. Below r = {:.4g}, where there are no pairs, the force is proportional to r. "
      "The mean force on two molecules along their line, with what all others do, is the slope of k_BT ln g.",
      match.found.first);
  if (match.beside)
    caption += fmt::format(" Lines: {}.", match.beside->name);
  return {{draw_svg(f), draw_svg(u)}, caption};
}

Figure matched_structure(ForceMatch const& match) {
  auto const& g = match.trial.g;
  auto const bins = [&](std::string label, std::vector<double> const& y, SeriesStyle style) {
    Series series{.label = std::move(label), .x = {}, .y = y, .y_error = {}, .style = style};
    for (std::size_t bin = 0; bin < y.size(); ++bin)
      series.x.push_back((double(bin) + 0.5) * g.width);
    return series;
  };
  auto plot = one_panel("structure", "Radial distribution", "r", "g(r)", {1});
  plot.panels[0].series = {bins("molecules", match.data.structure.g.g, SeriesStyle::points),
                           bins("particles", g.g, SeriesStyle::lines)};
  return {
      {draw_svg(plot)},
      "The force nearest to the molecules' gives particles their structure only where forces are sums over "
      "pairs."};
}

Table matched_table(ForceMatch const& match) {
  Table table{.header = {"r", "pairs", "f", "u", "mean force of two"}, .rows = {}, .caption = ""};
  if (match.beside)
    table.header.insert(table.header.end(), {"f beside", "u beside", "f apart in se", "u apart in se"});
  for (auto const bin : seen(match.found)) {
    auto const& found = match.found;
    auto& row = table.rows.emplace_back();
    row = {number_text(found.r(bin)), number_text(found.pairs[bin], 6), with_error_text(found.f[bin]),
           with_error_text(found.u[bin]), with_error_text(found.mean_force[bin])};
    if (auto const& beside = match.beside; beside && bin >= beside->first_bin)
      for (auto const* of : {&beside->f, &beside->u, &beside->f_se, &beside->u_se})
        row.push_back(number_text((*of)[bin - beside->first_bin], 3));
    row.resize(table.header.size());
  }
  table.caption = fmt::format("Standard errors from {} blocks.", match.found.blocks);
  return table;
}

void put_all(Json& json, std::string const& key, std::vector<cg::Estimate> const& values) {
  for (auto const& value : values)
    json[key].push_back(value.mean), json[key + "_se"].push_back(value.se);
}

} // namespace

Json force_match_json(ForceMatch const& match) {
  auto const& [data, found, trial, beside] = match;
  Json json{{"density", data.structure.density},
            {"mass", data.structure.mass},
            {"kT", data.structure.kT},
            {"cutoff", found.cutoff},
            {"first", found.first},
            {"unknowns", found.unknowns},
            {"blocks", found.blocks},
            {"longer_blocks", found.longer_blocks},
            {"g_difference", trial.difference}};
  put(json, "mean_square_force", found.mean_square);
  put(json, "explained", found.explained);
  put(json, "P", trial.P);
  if (data.structure.P)
    json["P_target"] = *data.structure.P;
  for (std::size_t bin = 0; bin < found.f.size(); ++bin)
    json["r"].push_back(found.r(bin));
  json["pairs"] = found.pairs;
  put_all(json, "f", found.f), put_all(json, "u", found.u), put_all(json, "mean_force", found.mean_force);
  json["g_width"] = trial.g.width, json["g"] = trial.g.g, json["g_target"] = data.structure.g.g;
  if (beside)
    json["beside"] = beside_json(*beside);
  json["warnings"] = force_match_warnings(match);
  return json;
}

std::vector<std::string> force_match_warnings(ForceMatch const& match) {
  std::vector<std::string> warnings;
  if (match.found.longer_blocks > most_growth)
    warnings.push_back(
        fmt::format("Standard errors are {:.2g} times larger with blocks twice as long: the run "
                    "is too short for them, and they are too small.",
                    match.found.longer_blocks));
  if (auto const& core = match.found.f.front(); core.mean < 0)
    warnings.push_back(
        fmt::format("The force attracts where the nearest pairs are, and below: {} in the first "
                    "bin. Particles may fall into each other.",
                    with_error_text(core)));
  return warnings;
}

std::string force_match_text(ForceMatch const& match) {
  auto const& found = match.found;
  auto text =
      fmt::format("force     {} coefficients from r = {:.4g} to {:.4g}; pairs explain {} of the forces' "
                  "square\n"
                  "particles difference of g(r) {:.2g}, P {}",
                  found.unknowns, found.first, found.cutoff, with_error_text(found.explained),
                  match.trial.difference, with_error_text(match.trial.P));
  if (match.data.structure.P)
    text += fmt::format("  (of the molecules: {})", number_text(*match.data.structure.P, 5));
  return text + "\n" + (match.beside ? beside_text(*match.beside) : "");
}

Report force_match_report(ForceMatch const& match) {
  auto const& head = match.data.head;
  Report report;
  report.title = "Pair force of " + head.name;
  report.lead =
      fmt::format("In units of {}: the pair force nearest to the forces on the molecules explains {} of "
                  "their square. Particles with it have the molecules' radial distribution but for "
                  "{:.2g} of its square.",
                  units_text(head), with_error_text(match.found.explained), match.trial.difference);
  report.warnings = force_match_warnings(match);
  report.sections = {{"Force and potential", {matched_figure(match), matched_table(match)}},
                     {"Structure", {matched_structure(match)}}};
  report.sources = {"Izvekov and Voth 2005", "Noid et al. 2008"};
  return report;
}

} // namespace mesobridge::workflows
