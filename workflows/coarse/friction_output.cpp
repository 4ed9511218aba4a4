#include "workflows/coarse/friction_output.hpp"
#include "workflows/coarse/plot_parts.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/summary.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

Figure integrals_figure(cg::PairFriction const& found) {
  auto self = one_panel("self", "Friction of a molecule", "t", "(1/k_BT) ∫_0^t <F F>", {0});
  auto& panel = self.panels[0];
  panel.series = {estimates("up to t", found.lag, found.self_integral, SeriesStyle::points, 0),
                  {.label = "at the plateau",
                   .x = {found.plateau, found.lag.back()},
                   .y = {found.self.mean, found.self.mean},
                   .y_error = {found.self.se, found.self.se},
                   .style = SeriesStyle::band,
                   .colour = 1}};
  auto pairs =
      one_panel("pairs", "Friction of pairs along their line", "t", "−(1/k_BT) ∫_0^t <F_μ F_ν>", {0});
  std::size_t const all = found.bins.size();
  int colour = 0;
  for (std::size_t const bin : {all / 5, all / 3, all / 2, all - 1})
    pairs.panels[0].series.push_back(estimates(fmt::format("r = {:.4g}", found.bins[bin].r), found.lag,
                                               found.bins[bin].par_integral, SeriesStyle::points, colour++));
  return {{draw_svg(self), draw_svg(pairs)},
          fmt::format(
              "Integrals up to t with one standard error. They are read at t = {:.4g}, {:.3g} memory times "
              "of the forces; what follows is noise, if the plateau is one.",
              found.plateau, found.plateau / found.memory)};
}

Figure correlation_figure(cg::PairFriction const& found) {
  auto plot = one_panel("correlation", "Memory of the forces", "t", "<F(t) F(0)>/<F^2>", {0});
  plot.panels[0].series = {estimates("", found.lag, found.correlation, SeriesStyle::points, 0)};
  return {{draw_svg(plot)},
          fmt::format("Of a molecule whose centre is held, less the mean over time. Its integral is {:.3g}.",
                      found.memory)};
}

std::vector<cg::Estimate> of_bins(cg::PairFriction const& found, cg::Estimate cg::FrictionBin::*member) {
  std::vector<cg::Estimate> all;
  for (auto const& bin : found.bins)
    all.push_back(bin.*member);
  return all;
}

Figure friction_figure(cg::PairFriction const& found) {
  std::vector<double> r;
  for (auto const& bin : found.bins)
    r.push_back(bin.r);
  auto const& table = found.table;
  auto along = one_panel("along", "Along the line of centres", "r", "γ_∥", {0}),
       across = one_panel("across", "Across the line of centres", "r", "γ_⊥", {0});
  auto const curve = [&](std::vector<double> const& y, std::vector<double> const& se) {
    return std::vector<Series>{
        {.label = "table", .x = table.r, .y = y, .y_error = se, .style = SeriesStyle::band, .colour = 1},
        {.label = "", .x = table.r, .y = y, .y_error = {}, .style = SeriesStyle::lines, .colour = 1}};
  };
  along.panels[0].series = curve(table.par, found.par_se);
  along.panels[0].series.push_back(
      estimates("pairs", r, of_bins(found, &cg::FrictionBin::par), SeriesStyle::points, 0));
  across.panels[0].series = curve(table.perp, found.perp_se);
  across.panels[0].series.push_back(
      estimates("pairs", r, of_bins(found, &cg::FrictionBin::perp), SeriesStyle::points, 0));
  return {{draw_svg(along), draw_svg(across)},
          "Points: correlations of the forces of pairs. Curves: smooth, nowhere negative, zero at the "
          "cut-off, with "
          "the sum over neighbours that is the friction of a molecule."};
}

Table sums_table(cg::PairFriction const& found) {
  cg::Estimate const far{found.self.mean - found.near.mean, found.near.se, found.near.n_eff};
  return {
      .header = {"sum over neighbours of (γ∥ + 2 γ⊥)/3", "", ""},
      .rows = {{"a molecule's own friction, which it must be", with_error_text(found.self), ""},
               {fmt::format("pairs within {:.4g}", found.table.cutoff()), with_error_text(found.near), ""},
               {"pairs beyond", with_error_text(far), ""},
               {"the table", number_text(found.table_sum, 6), ""}},
      .caption =
          "All forces together are zero, so that all pairs together have exactly the friction of a "
          "molecule. What pairs beyond the cut-off have, often less than zero, belongs to no pair friction "
          "of finite range: the table gives it to the near pairs."};
}

Table bins_table(cg::PairFriction const& found) {
  Table table{.header = {"r", "pairs", "γ∥", "γ⊥", "table γ∥", "table γ⊥"}};
  for (auto const& bin : found.bins)
    table.rows.push_back({number_text(bin.r), number_text(bin.pairs, 6), with_error_text(bin.par),
                          with_error_text(bin.perp), number_text(found.table.par_at(bin.r), 4),
                          number_text(found.table.perp_at(bin.r), 4)});
  table.caption = fmt::format("Standard errors from {} configurations.", found.configurations);
  return table;
}

} // namespace

std::string friction_csv(cg::FrictionTable const& table) {
  std::string text = "r,gamma_par,gamma_perp\n";
  for (std::size_t k = 0; k < table.r.size(); ++k)
    text += fmt::format("{:.10g},{:.10g},{:.10g}\n", table.r[k], table.par[k], table.perp[k]);
  return text;
}

Json friction_json(cg::PairFriction const& found) {
  Json json{{"configurations", found.configurations},
            {"time_held", found.time_held},
            {"memory_time", found.memory},
            {"plateau_time", found.plateau},
            {"cutoff", found.table.cutoff()},
            {"table_sum", found.table_sum},
            {"table_sum_deviation", found.table_sum / found.self.mean - 1}};
  put(json, "gamma_self", found.self);
  put(json, "gamma_self_rise_after_plateau", found.rise);
  put(json, "kT", found.kT);
  put(json, "force_variance", found.force_variance);
  put(json, "pair_sum_within_cutoff", found.near);
  for (auto const& bin : found.bins) {
    json["r"].push_back(bin.r), json["pairs"].push_back(bin.pairs);
    json["gamma_par"].push_back(bin.par.mean), json["gamma_par_se"].push_back(bin.par.se);
    json["gamma_perp"].push_back(bin.perp.mean), json["gamma_perp_se"].push_back(bin.perp.se);
  }
  json["table"] = {{"r", found.table.r},
                   {"gamma_par", found.table.par},
                   {"gamma_par_se", found.par_se},
                   {"gamma_perp", found.table.perp},
                   {"gamma_perp_se", found.perp_se}};
  for (std::size_t k = 0; k < found.lag.size(); ++k) {
    json["lag"].push_back(found.lag[k]);
    json["gamma_self_integral"].push_back(found.self_integral[k].mean);
    json["gamma_self_integral_se"].push_back(found.self_integral[k].se);
    json["force_correlation"].push_back(found.correlation[k].mean);
  }
  return json;
}

std::string plateau_warning(cg::PairFriction const& found) {
  constexpr double allowed = 3; // standard errors
  if (std::abs(cg::deviation(found.rise, 0)) <= allowed)
    return "";
  return fmt::format(
      "The friction changes by {} from the time {:.4g} to {:.4g}: part of the forces' memory is slow, and "
      "the value depends on where it is read (--plateau).",
      with_error_text(found.rise), found.plateau, found.lag.back());
}

std::string friction_text(cg::PairFriction const& found) {
  return fmt::format("gamma_self  {}  per direction, the integral up to {:.4g} ({:.3g} memory times)\n"
                     "            {}  at four times that, {:.4g}\n"
                     "pairs       {}  the sum over those within {:.4g}; the table's: {}\n"
                     "k_B T       {}  of the motion inside, {} configurations held for {:.4g} each\n",
                     with_error_text(found.self), found.plateau, found.plateau / found.memory,
                     with_error_text(found.self_integral.back()), found.lag.back(),
                     with_error_text(found.near), found.table.cutoff(), number_text(found.table_sum, 5),
                     with_error_text(found.kT), found.configurations, found.time_held);
}

Report friction_report(cg::PairFriction const& found, std::string const& name, std::string const& units) {
  Report report;
  report.title = "Pair friction of " + name;
  report.lead =
      fmt::format("In units of {}: a molecule whose centre is held feels the friction {} per direction. "
                  "Correlations of the forces on {} held configurations divide it among the pairs.",
                  units, with_error_text(found.self), found.configurations);
  report.sections = {
      {"Friction over distance", {friction_figure(found), sums_table(found), bins_table(found)}},
      {"Plateau", {integrals_figure(found), correlation_figure(found)}}};
  if (auto const warning = plateau_warning(found); !warning.empty())
    report.warnings.push_back(warning);
  report.sources = {"Hijon et al. 2010"};
  return report;
}

} // namespace mesobridge::workflows
