#include "workflows/report/drawn.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/ideal_gas_study.hpp"
#include "workflows/reproduce/published.hpp"
#include "workflows/summary.hpp"

/// The figures of the thesis's chapter 4 that show how the energy drifts.
namespace mesobridge::workflows {
namespace {

Series law_curve(std::string label, double prefactor, double exponent, double low, double high,
                 SeriesStyle style, int colour) {
  Series series{.label = std::move(label), .style = style, .colour = colour};
  for (int k = 0; k <= 20; ++k) {
    double const x = low * std::pow(high / low, k / 20.0);
    series.x.push_back(x), series.y.push_back(prefactor * std::pow(x, exponent));
  }
  return series;
}

/// Drift rates over the time step with our power laws.
Plot drift_plot(std::string name, std::string title, std::vector<LineResult> const& lines) {
  auto plot = over_time_step(std::move(name), std::move(title), "drift of E [1 / reduced time]", true);
  int colour = 0;
  for (auto const& line : lines) {
    auto const [dt, rates] = line.drifts();
    auto points = resolved_points(line.label, dt, rates, colour);
    if (auto const law = line.drift_law(); law.known())
      plot.panels[0].series.push_back(law_curve("", std::exp(law.log_prefactor.mean), law.exponent.mean,
                                                law.x_min, law.x_max, SeriesStyle::lines, colour));
    if (!points.x.empty())
      plot.panels[0].series.push_back(std::move(points));
    ++colour;
  }
  return plot;
}

std::string exponents_text(std::vector<LineResult> const& lines) {
  std::vector<std::string> parts;
  for (auto const& line : lines)
    if (auto const law = line.drift_law(); law.known())
      parts.push_back(fmt::format("{} for {}", with_error_text(law.exponent), line.label));
  return parts.empty() ? "no exponent is resolved" : fmt::format("exponents {}", fmt::join(parts, ", "));
}

/// What all these figures share: curves, a table, the failures, what the text says.
Reproduced assembled(std::string title, std::string lead, std::vector<LineResult> const& lines,
                     std::vector<Plot> const& plots, std::vector<std::string> const& statements) {
  Reproduced found;
  found.summary["lines"] = lines_json(lines);
  Section ours{
      "Ours",
      {drawn(plots, "Points with standard errors; lines are power laws through them."), drift_table(lines)}};
  if (auto const failed = failures(lines); !failed.empty())
    ours.content.emplace_back(
        Paragraph{fmt::format("Runs that could not go on: {}", fmt::join(failed, "; "))});
  Section theirs{"What the thesis says", {}};
  for (auto const& statement : statements)
    theirs.content.emplace_back(Paragraph{statement});
  found.report = {.title = std::move(title),
                  .lead = std::move(lead),
                  .verdicts = {},
                  .sections = {ours, theirs},
                  .provenance = {}};
  return found;
}

StudyLine line(std::string label, Scene scene, std::vector<double> dt, double time) {
  return {std::move(label), std::move(scene), std::move(dt), time};
}

} // namespace

Reproduced reproduce_figure_4_2(ReproduceOptions const& options, Context const& context) {
  auto const lines = run_lines(
      "Figure 4.2",
      {line("SSA, K = 100", thesis_ideal_gas(100, "ssa", options.seed), {0.3, 0.35, 0.4, 0.45}, 600)},
      options, context);
  return assembled(
      "Figure 4.2: the energy of SSA drifts linearly, K = 100",
      "Relative energy error in time for several time steps; " + exponents_text(lines) + ".", lines,
      {energy_in_time("energy", "SSA, ideal gas, K = 100", lines),
       drift_plot("drift", "Drift against time step", lines)},
      {"Figure 4.2 shows a linear drift of the relative energy error for K = 100; its numbers are not in "
       "the text."});
}

Reproduced reproduce_figure_4_3(ReproduceOptions const& options, Context const& context) {
  std::vector<StudyLine> plan;
  for (double const K : {10.0, 50.0, 100.0})
    plan.push_back(
        line(fmt::format("SSA, K = {:g}", K), thesis_ideal_gas(K, "ssa", options.seed),
             K == 10 ? std::vector{0.1, 0.15, 0.2, 0.25, 0.3} : std::vector{0.15, 0.2, 0.3, 0.4, 0.45}, 400));
  auto const lines = run_lines("Figure 4.3", plan, options, context);
  auto const printed = published("thesis-figure-4.3.csv");
  auto plot = drift_plot("drift", "Drift of SSA: ours (points, lines), printed laws (dashes)", lines);
  int colour = 0;
  Table table{.header = {"K", "our exponent", "printed", "our rate at dt = 0.2", "printed law at dt = 0.2"},
              .caption = printed.source};
  Json laws = Json::array();
  for (std::size_t k = 0; k < lines.size(); ++k) {
    auto const& row = printed.table.rows.at(k).cells;
    double const exponent = printed.value(row[0], "exponent"), prefactor = printed.value(row[0], "prefactor");
    plot.panels[0].series.push_back(law_curve("", prefactor, exponent, lines[k].dt.front(),
                                              lines[k].dt.back(), SeriesStyle::dashes, colour++));
    auto const law = lines[k].drift_law();
    Json one{{"K", std::stod(row[0])}, {"printed_exponent", exponent}, {"printed_prefactor", prefactor}};
    if (law.known()) {
      auto const at = law.logarithm_at(0.2);
      cg::Estimate const rate{std::exp(at.mean), std::exp(at.mean) * at.se, at.n_eff};
      put(one, "exponent", law.exponent), put(one, "rate_at_0.2", rate);
      table.rows.push_back({row[0], with_error_text(law.exponent), number_text(exponent),
                            with_error_text(rate), number_text(prefactor * std::pow(0.2, exponent), 3)});
    }
    laws.push_back(one);
  }
  auto found =
      assembled("Figure 4.3: the drift of SSA against the time step",
                "Power laws alpha = C dt^n: " + exponents_text(lines) + "; 5.44 is printed for all sizes.",
                lines, {plot},
                {"The exponent is printed as 5.44, independent of K, with prefactors 9.50, 181 and 217 for K "
                 "= 10, 50 and 100.",
                 "The printed prefactors cannot be compared: with them the thesis's own choice, dt = 0.13 at "
                 "K = 10 for 0.5 % after "
                 "5e5 steps, which asks for 7.7e-8 per unit of time, would drift at 1.4e-4.",
                 "Why about five: a step of the conservative dynamics gets the energy wrong by W of order "
                 "dt^3, fluctuation and "
                 "dissipation make successive W forget each other, and the heat they leave is Var(W)/2 k_B T "
                 "a step: dt^6 a step, "
                 "dt^5 a unit of time. Where friction is weak against 1/dt successive W cancel in part, "
                 "which gives dt^4; near "
                 "the limit of stability higher orders steepen the law."});
  found.summary["laws"] = laws;
  found.report.sections[0].content.emplace_back(table);
  return found;
}

Reproduced reproduce_figure_4_4(ReproduceOptions const& options, Context const& context) {
  auto const lines =
      run_lines("Figure 4.4",
                {line("SER, K = 10", thesis_ideal_gas(10, "ser", options.seed),
                      {0.01, 0.015, 0.02, 0.025, 0.03, 0.035, 0.05}, 100),
                 line("SSA, K = 10", thesis_ideal_gas(10, "ssa", options.seed), {0.02, 0.035, 0.3}, 100)},
                options, context);
  return assembled(
      "Figure 4.4: SER", "Energy drift of SER at K = 10 beside SSA: " + exponents_text(lines) + ".", lines,
      {drift_plot("drift", "Drift of SER and SSA", lines), energy_in_time("energy", "Energy", lines)},
      {"Negative internal energies may appear with SER for time steps as small as 0.035, while SSA runs up "
       "to 0.3 over a time of 500.",
       "Time steps that are short enough for SER show no significant drift with SSA."});
}

Reproduced reproduce_figure_4_7(ReproduceOptions const& options, Context const& context) {
  auto const lines = run_lines(
      "Figure 4.7",
      {line("EMS, K = 5", thesis_ideal_gas(5, "ems", options.seed), {0.1, 0.15, 0.2, 0.25, 0.3}, 600)},
      options, context);
  return assembled(
      "Figure 4.7: energy in time with the Metropolised scheme, K = 5",
      "Relative energy error of EMS for several time steps; " + exponents_text(lines) + ".", lines,
      {energy_in_time("energy", "EMS, ideal gas, K = 5", lines)},
      {"A linear drift is observed, as is usual with such splittings; the figure's numbers are not in the "
       "text."});
}

Reproduced reproduce_figure_4_8(ReproduceOptions const& options, Context const& context) {
  std::vector<double> const dt{0.1, 0.15, 0.2, 0.3, 0.35};
  auto const lines =
      run_lines("Figure 4.8",
                {line("EMS, K = 5", thesis_ideal_gas(5, "ems", options.seed), dt, 400),
                 line("AMS, K = 5", thesis_ideal_gas(5, "ams", options.seed), dt, 400),
                 line("SSA, K = 5", thesis_ideal_gas(5, "ssa", options.seed), {0.01, 0.02, 0.1}, 100)},
                options, context);
  return assembled(
      "Figure 4.8: drift of SSA, EMS and AMS, K = 5",
      "Drift rates of the Metropolised schemes and, where it runs, SSA: " + exponents_text(lines) + ".",
      lines, {drift_plot("drift", "Drift at K = 5", lines)},
      {"The drift is alike for all methods; SSA is limited to small time steps, the Metropolised schemes "
       "reach much larger ones.",
       "The limits with the full dynamics are much smaller than with fluctuation and dissipation alone."});
}

Reproduced reproduce_figure_4_9(ReproduceOptions const& options, Context const& context) {
  std::vector<double> const dt{0.1, 0.2, 0.3, 0.392};
  std::vector<StudyLine> plan;
  for (std::string const scheme : {"ems", "ams"})
    for (std::int64_t const every : {1, 5, 10}) {
      Scene scene = thesis_ideal_gas(5, scheme, options.seed);
      scene.scheme.fluctuate_every = every;
      plan.push_back(line(fmt::format("{} MTS {}", scheme, every), scene, dt, 300));
    }
  auto const lines = run_lines("Figure 4.9", plan, options, context);
  auto const printed = published("thesis-section-4.3.3.csv");
  auto plot = over_time_step("ratio", "Drift with multiple time steps over that without", "ratio", true);
  Json ratios = Json::array();
  for (std::size_t k = 0; k < lines.size(); ++k) {
    auto const& single = lines[k - k % 3];
    if (k % 3 == 0)
      continue;
    std::vector<double> x;
    std::vector<cg::Estimate> y;
    for (std::size_t d = 0; d < dt.size(); ++d) {
      auto const &many = lines[k].trials[d], &one = single.trials[d];
      if (!many.knows_drift() || !one.knows_drift() || !(one.drift().rate > 2 * one.drift().se))
        continue;
      double const ratio = many.drift().rate / one.drift().rate;
      double const se = std::abs(ratio) *
                        std::hypot(many.drift().se / many.drift().rate, one.drift().se / one.drift().rate);
      x.push_back(dt[d]), y.push_back({ratio, se, 8});
      Json row{{"label", lines[k].label}, {"dt_reduced", dt[d]}};
      put(row, "ratio", y.back());
      ratios.push_back(row);
    }
    auto points = resolved_points(lines[k].label, x, y, static_cast<int>(k));
    if (!points.x.empty())
      plot.panels[0].series.push_back(points);
  }
  auto found = assembled(
      "Figure 4.9: multiple time steps", "Drift of MTS over that of single time steps, K = 5.", lines,
      {plot, drift_plot("drift", "Drift", lines)},
      {fmt::format("At dt = 0.392 the drift is halved for theta = 5 and divided by six for theta = 10 "
                   "(ratios {:g} and {:.3f}).",
                   printed.value("drift_ratio_mts5", "low"), printed.value("drift_ratio_mts10", "low")),
       printed.source});
  found.summary["ratios"] = ratios;
  return found;
}

} // namespace mesobridge::workflows
