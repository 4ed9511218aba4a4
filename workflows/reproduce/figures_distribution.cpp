#include "cg/distribution_error.hpp"
#include "sdpd/observe/gamma_law.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/ideal_gas_study.hpp"
#include "workflows/reproduce/published.hpp"
#include "workflows/summary.hpp"

/// The figures of the thesis's chapter 4 that show fluctuation and dissipation alone: particles stay in
/// place.
namespace mesobridge::workflows {
namespace {

constexpr double K = 5;

std::vector<LineResult> run_in_place(std::string const& title, ReproduceOptions const& options,
                                     Context const& context) {
  std::vector<StudyLine> plan;
  for (std::string const scheme : {"ems", "ams"}) {
    Scene scene = thesis_ideal_gas(K, scheme, options.seed);
    scene.scheme.conservative = "none";
    cg::Bins const as_in_the_thesis{.lower = 0.1, .upper = 20, .count = 150};
    plan.push_back({scheme, scene, {0.5, 1, 2, 3, 5}, 1000, as_in_the_thesis});
  }
  return run_lines(title, plan, options, context);
}

Plot distribution_plot(std::vector<LineResult> const& lines, std::size_t which) {
  auto plot =
      one_panel("distribution", fmt::format("Internal energies, K = {:g}, dt = {:g}", K, lines[0].dt[which]),
                "eps / k_B T", "probability density");
  plot.x.max = 16.0;
  auto const& bins = lines[0].trials[which].bins;
  std::vector<double> x;
  for (std::size_t b = 0; b < bins.count; ++b)
    x.push_back(bins.lower + (static_cast<double>(b) + 0.5) * bins.width());
  for (auto const& line : lines)
    if (!line.trials[which].failed())
      plot.panels[0].series.push_back({.label = line.label,
                                       .x = x,
                                       .y = line.trials[which].histogram(),
                                       .y_error = {},
                                       .style = SeriesStyle::steps});
  plot.panels[0].series.push_back({.label = "exact",
                                   .x = x,
                                   .y = sdpd::gamma_law(K, bins),
                                   .y_error = {},
                                   .style = SeriesStyle::lines,
                                   .colour = 6});
  return plot;
}

cg::Estimate share(double rejected) {
  return {rejected, 0, 1};
}

} // namespace

Reproduced reproduce_figure_4_5(ReproduceOptions const& options, Context const& context) {
  auto const lines = run_in_place("Figure 4.5", options, context);
  auto error_plot =
      over_time_step("error", "Error of the distribution (4.18)", "relative quadratic error", true);
  Table table{
      .header = {"scheme", "dt", "error (4.18)", "its statistical part", "var eps / exact"},
      .caption = "150 bins from 0.1 to 20 k_B T as in the thesis. The statistical part is what two halves of "
                 "the sample differ by."};
  Json rows = Json::array();
  int colour = 0;
  for (auto const& line : lines) {
    std::vector<double> x;
    std::vector<cg::Estimate> y;
    for (std::size_t k = 0; k < line.dt.size(); ++k) {
      auto const& trial = line.trials[k];
      if (trial.failed())
        continue;
      auto const law = sdpd::gamma_law(K, trial.bins);
      double const shape = 1.5 * (K - 1);
      cg::Estimate const error{cg::distribution_error(trial.histogram(), law),
                               cg::distribution_noise(trial.first_half, trial.second_half, law), 2};
      cg::Estimate const width{trial.eps_variance.mean / shape, trial.eps_variance.se / shape,
                               trial.eps_variance.n_eff};
      x.push_back(line.dt[k]), y.push_back({error.mean, 0, 2});
      table.rows.push_back({line.label, number_text(line.dt[k]), number_text(error.mean, 3),
                            number_text(error.se, 3), with_error_text(width)});
      Json row{{"scheme", line.label},
               {"dt_reduced", line.dt[k]},
               {"eps_distribution_error", error.mean},
               {"eps_distribution_noise", error.se}};
      put(row, "eps_variance_over_exact", width);
      rows.push_back(row);
    }
    error_plot.panels[0].series.push_back(resolved_points(line.label, x, y, colour++));
  }
  Reproduced found;
  found.summary["trials"] = rows;
  found.report = {
      .title = "Figure 4.5: distributions of the Metropolised schemes",
      .lead = "Fluctuation and dissipation alone, ideal gas, K = 5. EMS follows the exact law at any time "
              "step; AMS, "
              "which only refuses what would leave the equation of state, spreads the energies too widely.",
      .verdicts = {},
      .sections =
          {{"Ours",
            {Figure{{draw_svg(distribution_plot(lines, 1)), draw_svg(error_plot)},
                    "Distribution at dt = 1 and "
                    "error over the time step."},
             table}},
           {"What the thesis says",
            {Paragraph{
                "The only source of error for EMS is statistical. No systematic bias of AMS was apparent up "
                "to dt = 5, with errors of the same order as those of EMS; the variance shows one."}}}},
      .provenance = {}};
  return found;
}

Reproduced reproduce_figure_4_6(ReproduceOptions const& options, Context const& context) {
  auto const lines = run_in_place("Figure 4.6", options, context);
  auto const printed = published("thesis-section-4.3.3.csv");
  auto plot = over_time_step("rejected", "Rejected steps of pairs", "share", true);
  Table table{.header = {"scheme", "dt", "Metropolis", "out of the equation of state"},
              .caption = "Shares of all steps of pairs."};
  Json rows = Json::array();
  int colour = 0;
  auto add = [&](std::string label, LineResult const& line, double sdpd::TrialResult::*which) {
    std::vector<double> x;
    std::vector<cg::Estimate> y;
    for (std::size_t k = 0; k < line.dt.size(); ++k)
      if (!line.trials[k].failed())
        x.push_back(line.dt[k]), y.push_back(share(line.trials[k].*which));
    auto points = resolved_points(std::move(label), x, y, colour++);
    if (!points.x.empty())
      plot.panels[0].series.push_back(std::move(points));
  };
  add("EMS, Metropolis", lines[0], &sdpd::TrialResult::rejected_metropolis);
  add("EMS, negative energy", lines[0], &sdpd::TrialResult::rejected_out_of_domain);
  add("AMS, negative energy", lines[1], &sdpd::TrialResult::rejected_out_of_domain);
  for (auto const& line : lines)
    for (std::size_t k = 0; k < line.dt.size(); ++k) {
      auto const& trial = line.trials[k];
      if (trial.failed())
        continue;
      table.rows.push_back({line.label, number_text(line.dt[k]), number_text(trial.rejected_metropolis, 3),
                            number_text(trial.rejected_out_of_domain, 3)});
      rows.push_back({{"scheme", line.label},
                      {"dt_reduced", line.dt[k]},
                      {"rejected_metropolis", trial.rejected_metropolis},
                      {"rejected_out_of_domain", trial.rejected_out_of_domain}});
    }
  Reproduced found;
  found.summary["trials"] = rows;
  found.report = {
      .title = "Figure 4.6: rejected steps",
      .lead = "Fluctuation and dissipation alone, ideal gas, K = 5.",
      .verdicts = {},
      .sections = {{"Ours", {Figure{{draw_svg(plot)}, "Shares of all steps of pairs."}, table}},
                   {"What the thesis says",
                    {Paragraph{fmt::format(
                         "EMS rejects {:g} to {:g} of the steps for dt = 1 to 5, AMS {:g} to {:g}; both grow "
                         "as dt^{:g}.",
                         printed.value("rejected_ems", "low"), printed.value("rejected_ems", "high"),
                         printed.value("rejected_ams", "low"), printed.value("rejected_ams", "high"),
                         printed.value("rejection_exponent", "low"))},
                     Paragraph{"Ours for AMS are the printed ones. A Metropolis test that leaves the exact "
                               "law, as ours is seen "
                               "to do, has to reject more than is printed."}}}},
      .provenance = {}};
  return found;
}

} // namespace mesobridge::workflows
