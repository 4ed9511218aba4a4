#include "workflows/coarse/star_to_dpde_report.hpp"
#include "workflows/coarse/cost_section.hpp"
#include "workflows/json_file.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/summary.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

/// A column of numbers of a JSON file, and of their errors where it has them.
Series series_in(Json const& json, std::string label, char const* x, std::string const& y,
                 SeriesStyle style) {
  Series series{.label = std::move(label), .x = json.at(x), .y = json.at(y), .style = style};
  if (json.contains(y + "_se"))
    series.y_error = json.at(y + "_se").get<std::vector<double>>();
  return series;
}

Series radial_series(RadialEstimate const& of, std::string label, SeriesStyle style) {
  Series series{.label = std::move(label), .style = style};
  for (std::size_t bin = 0; bin < of.g.size(); ++bin) {
    series.x.push_back((double(bin) + 0.5) * of.width), series.y.push_back(of.g[bin].mean);
    if (style == SeriesStyle::points)
      series.y_error.push_back(of.g[bin].se);
  }
  return series;
}

Figure structure_figure(Kept const& kept) {
  auto plot = one_panel("structure", "Radial distribution of the centres", "r", "g(r)", {1});
  plot.panels[0].series = {radial_series(kept.g_molecules, "molecules", SeriesStyle::points),
                           radial_series(kept.own().g_particles, "particles", SeriesStyle::lines)};
  return {{draw_svg(plot)},
          fmt::format(
              "They differ by {} of g in the root mean square, where noise alone makes {}; by {} at most.",
              number_text(kept.own().g.share.mean, 2), number_text(kept.own().g.share.se, 2),
              number_text(kept.own().g.largest, 2))};
}

Figure laws_figure(std::filesystem::path const& directory) {
  auto const friction = read_json(directory / "friction/friction.json"),
             exchange = read_json(directory / "exchange/exchange.json");
  auto of_friction = one_panel("friction", "Friction of two molecules", "r", "γ(r)", {0});
  auto const& table = friction.at("table");
  of_friction.panels[0].series = {
      series_in(friction, "along the line of centres", "r", "gamma_par", SeriesStyle::points),
      series_in(friction, "across it", "r", "gamma_perp", SeriesStyle::points),
      series_in(table, "along, as the particles have it", "r", "gamma_par", SeriesStyle::lines),
      series_in(table, "across, likewise", "r", "gamma_perp", SeriesStyle::lines)};
  auto conduction = one_panel("conduction", "Conduction between two molecules", "r", "κ(r)", {0});
  conduction.panels[0].series = {series_in(exchange, "", "r", "kappa", SeriesStyle::points)};
  return {{draw_svg(of_friction), draw_svg(conduction)},
          "Measured in the melt; nothing is adjusted to the run."};
}

Table kept_table(Kept const& kept) {
  Table table{.header = {"", "molecules", "particles", "difference", "in standard errors", "wanted within"}};
  for (auto const& of : kept.own().quantities) {
    double const apart = of.particles.mean - of.molecules.mean;
    table.rows.push_back({of.what, with_error_text(of.molecules), with_error_text(of.particles),
                          fmt::format("{:+.2f} %", 100 * apart / std::abs(of.molecules.mean)),
                          fmt::format("{:+.1f}", apart / std::hypot(of.molecules.se, of.particles.se)),
                          fmt::format("{:g} %", 100 * of.share)});
  }
  return table;
}

std::vector<VerdictLine> verdicts_of(Kept const& kept) {
  std::vector<VerdictLine> lines;
  bool const same = kept.own().g.largest <= 0.02 || kept.own().g.largest_in_se <= 4;
  lines.push_back({.what = "radial distribution",
                   .found = fmt::format("apart by {} at most", number_text(kept.own().g.largest, 2)),
                   .expected = "0",
                   .verdict = same ? Verdict::passed : Verdict::failed,
                   .deviation = fmt::format("{:.1f} se (the farthest of {}); wanted: 0.02 or 4 se",
                                            kept.own().g.largest_in_se, kept.own().g.bins)});
  for (auto const& of : kept.own().quantities)
    lines.push_back({.what = of.what,
                     .found = with_error_text(of.particles),
                     .expected = with_error_text(of.molecules),
                     .verdict = of.kept() ? Verdict::passed : Verdict::failed,
                     .deviation = fmt::format("{:+.1f} se; wanted: {:g} % or 3 se",
                                              (of.particles.mean - of.molecules.mean) /
                                                  std::hypot(of.molecules.se, of.particles.se),
                                              100 * of.share)});
  return lines;
}

Section commands(StarToDpdePlan const& plan, std::filesystem::path const& directory) {
  Section section{
      "The stages one by one",
      {Paragraph{"Each line can be typed as it stands, in the folder in which this one was called:"}}};
  auto stages = model_stages(plan, directory);
  auto const later = run_stages(plan, directory);
  stages.insert(stages.end(), later.begin(), later.end());
  for (auto const& stage : stages)
    section.content.emplace_back(Paragraph{"`" + line_of(stage) + "`"});
  section.content.emplace_back(
      Files{{{"melt/transport.html", "motion of the molecules"},
             {"potential/potential.html", "the search for the potential"},
             {"friction/friction.html", "running integrals of the frictions"},
             {"exchange/exchange.html", "how energies pass from molecule to molecule"},
             {"run/report.html", "the run of the particles"},
             {"run/transport.html", "their motion"}}});
  return section;
}

std::string key_of(KeptQuantity const& of) {
  return of.key == "D" ? "diffusion" : of.key;
}

void put_run(Json& json, Kept const& kept, KeptRun const& run) {
  for (auto const& of : run.quantities)
    put(json, key_of(of) + "_dpde", of.particles);
  put(json, "g_deviation", run.g.share);
  json["g_largest_difference"] = run.g.largest;
  json["seconds_per_molecule_and_time_dpde"] = run.cost;
  json["speed_up"] = kept.speed_up(run);
}

} // namespace

Json star_to_dpde_summary(StarToDpdePlan const& plan, Kept const& kept) {
  Json json{{"star", plan.melt.star.name()}, {"rho", plan.melt.rho}, {"molecules", plan.melt.molecules}};
  for (auto const& of : kept.own().quantities)
    put(json, key_of(of) + "_md", of.molecules);
  put_run(json, kept, kept.own());
  put(json, "gamma_self", kept.gamma_self);
  json["seconds_per_molecule_and_time_md"] = kept.cost_molecules;
  for (auto const& run : kept.runs) {
    json["runs"].push_back({{"name", run.run.name}, {"dt", run.run.dt}, {"model", run.run.model.string()}});
    put_run(json["runs"].back(), kept, run);
  }
  return json;
}

Report star_to_dpde_report(StarToDpdePlan const& plan, std::filesystem::path const& directory,
                           Kept const& kept) {
  Report report;
  report.title = fmt::format("From a melt of {} stars to a DPDE fluid", plan.melt.star.name());
  report.lead = fmt::format(
      "One particle for each molecule, at {} beads per σ^3. Mass, internal energy, potential, friction and "
      "conduction were "
      "measured in the melt; the run shows what they keep of it. It costs {} times less than the molecules.",
      number_text(plan.melt.rho, 4), number_text(kept.speed_up(kept.own()), 2));
  report.verdicts = verdicts_of(kept);
  if (has_resumed(directory / "stages.json"))
    report.warnings.emplace_back(
        "Some stages were interrupted: processor times and what follows from them are of their last calls.");
  report.sections = {{"What is kept", {kept_table(kept), structure_figure(kept)}},
                     beside_section(kept.own().particles, kept.molecules),
                     {"What two particles do to each other", {laws_figure(directory)}},
                     cost_section(kept),
                     commands(plan, directory)};
  return report;
}

} // namespace mesobridge::workflows
