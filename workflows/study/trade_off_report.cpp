#include "workflows/report/drawn.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/study/trade_off_parts.hpp"

namespace mesobridge::workflows {
namespace {

/// A value as a logarithmic axis can show it: its size and error or, where it is not resolved, its upper
/// limit with a bar that reaches zero.
cg::Estimate on_logarithmic_axis(cg::Estimate const& value) {
  double const size = std::abs(value.mean);
  if (size > value.se)
    return {size, value.se, value.n_eff};
  return {size + value.se, size + value.se, value.n_eff};
}

/// A point for every trial that came to its end.
template <class X, class Y>
Plot over_trials(TradeOff const& found, double K, Plot plot, X const& x, Y const& y) {
  int colour = 0;
  for (auto const& configuration : found.configurations) {
    if (configuration.K != K)
      continue;
    Series series{
        .label = plain(short_name(configuration)), .x = {}, .y = {}, .y_error = {}, .colour = colour++};
    for (std::size_t k = 0; k < configuration.trials.size(); ++k) {
      auto const& trial = configuration.trials[k];
      if (trial.failed())
        continue;
      auto const value = on_logarithmic_axis(y(configuration, trial));
      if (!(value.mean > 0)) // exactly zero has no place on the axis
        continue;
      series.x.push_back(x(trial, found.plan.dt[k]));
      series.y.push_back(value.mean), series.y_error.push_back(value.se);
    }
    if (!series.x.empty())
      plot.panels[0].series.push_back(series);
  }
  return plot;
}

Plot frame(std::string name, std::string title, std::string x, std::string y) {
  Plot plot{.name = std::move(name),
            .title = std::move(title),
            .x = {.label = std::move(x), .logarithmic = true},
            .panels = {Panel{}}};
  plot.panels[0].y = {.label = std::move(y), .logarithmic = true};
  return plot;
}

/// Points of several series at the same x, moved apart so that each is seen.
Plot side_by_side(Plot plot) {
  constexpr double apart = 0.025; // relative, on a logarithmic axis
  auto& series = plot.panels[0].series;
  double const middle = (static_cast<double>(series.size()) - 1) / 2;
  for (std::size_t k = 0; k < series.size(); ++k)
    for (double& x : series[k].x)
      x *= 1 + apart * (static_cast<double>(k) - middle);
  return plot;
}

Table trial_table(TradeOff const& found, double K) {
  auto const units = units_of(found, K);
  Table table{
      .header = {"scheme", "dt", fmt::format("us / particle {}", time_name(units)),
                 fmt::format("drift [1/{}]", time_name(units)), "bias T_kin [%]", "bias T_int [%]",
                 "bias P [%]", "bias D [%]", "bias var eps [%]", "eps error (4.18)", "its noise",
                 "rejected [%]"},
      .caption =
          found.scene.features().energies
              ? "dt in reduced units. Bias: against the trial of the exact scheme with the shortest time "
                "step; of the ideal gas's energies against their exact law."
              : "dt in reduced units. Bias: of T_kin against the set temperature, which the thermostat "
                "keeps; of P against the trial with the shortest time step."};
  bool const energies = found.scene.features().energies;
  auto of_energies = [&](std::string text) { return energies ? std::move(text) : std::string("-"); };
  auto percent = [](cg::Estimate const& e) { return with_error_text({100 * e.mean, 100 * e.se, e.n_eff}); };
  for (auto const& of : found.configurations) {
    if (of.K != K)
      continue;
    for (std::size_t k = 0; k < of.trials.size(); ++k) {
      auto const& trial = of.trials[k];
      double const dt = found.plan.dt[k];
      if (trial.failed()) {
        table.rows.push_back(
            {short_name(of), number_text(dt, 3), "fails", "", "", "", "", "", "", "", "", ""});
        continue;
      }
      auto const bias = found.bias(of, trial);
      table.rows.push_back(
          {short_name(of), number_text(dt, 3), number_text(trial.us_per_particle_step / (dt * units.ps), 3),
           of_energies(with_error_text(estimate(trial.drift(), units.ps))), percent(bias.T_kin),
           of_energies(percent(bias.T_int)), percent(bias.P), bias.D.se > 0 ? percent(bias.D) : "-",
           of_energies(percent(bias.eps_variance)), of_energies(number_text(bias.distribution, 2)),
           of_energies(number_text(bias.distribution_noise, 2)),
           number_text(100 * (trial.rejected_out_of_domain + trial.rejected_metropolis), 2)});
    }
  }
  return table;
}

Table limit_table(TradeOff const& found, double K) {
  Table table{.header = {"scheme", "largest stable dt", "smallest failing dt", "drift exponent", "points"},
              .caption =
                  "Stable: a run of 50 reduced units of time goes through and its kinetic temperature stays "
                  "below twice the set one. The drift is taken as C dt^n."};
  for (auto const& of : found.configurations)
    if (of.K == K)
      table.rows.push_back({short_name(of), of.stable_dt ? number_text(*of.stable_dt, 3) : "none",
                            of.failing_dt ? number_text(*of.failing_dt, 3) : "none found",
                            of.drift.known() ? with_error_text(of.drift.exponent) : "-",
                            number_text(of.drift.exponent.n_eff)});
  return table;
}

Section size_section(TradeOff const& found, double K) {
  auto const units = units_of(found, K);
  std::string const tag = fmt::format("K{:.0f}", K), time = time_name(units);
  auto cost = [&](sdpd::TrialResult const& trial, double dt) {
    return trial.us_per_particle_step / (dt * units.ps);
  };
  auto drift = [&](Configuration const&, sdpd::TrialResult const& trial) {
    return estimate(trial.drift(), units.ps);
  };
  auto error = [&](Configuration const& of, sdpd::TrialResult const& trial) {
    auto const bias = found.bias(of, trial);
    return cg::Estimate{bias.distribution, bias.distribution_noise, 1};
  };
  std::string const cost_axis = fmt::format("processor time [us per particle and {}]", time);
  auto plots = [&]() -> std::vector<Plot> {
    if (!found.scene.features().energies)
      return {over_trials(found, K, frame("bias" + tag, "Bias of T_kin", cost_axis, "|bias of T_kin|"), cost,
                          [&](Configuration const& of, sdpd::TrialResult const& trial) {
                            auto const bias = found.bias(of, trial).T_kin;
                            return cg::Estimate{std::abs(bias.mean), bias.se, bias.n_eff};
                          })};
    std::string const drift_axis = fmt::format("energy drift [1/{}]", time);
    return {over_trials(found, K, frame("pareto" + tag, "Drift against cost", cost_axis, drift_axis), cost,
                        drift),
            side_by_side(over_trials(
                found, K, frame("drift" + tag, "Drift against time step", "dt [reduced]", drift_axis),
                [](auto const&, double dt) { return dt; }, drift)),
            over_trials(found, K,
                        frame("bias" + tag, "Error of the energies' distribution", cost_axis,
                              "distribution error (4.18)"),
                        cost, error)};
  };
  return {
      K > 0 ? fmt::format("Particles of size K = {:g}", K) : "Particles",
      {drawn(plots(), "Every point is a run; below and to the left is better. What is not resolved stands at "
                      "its upper limit, value and standard error, with a bar that goes down. Points of one "
                      "time step stand side by side."),
       trial_table(found, K), limit_table(found, K)}};
}

Section recommendation_section(TradeOff const& found, Target const& target) {
  Section section{"Recommended", {Paragraph{"For " + target_text(target) + ":"}}};
  for (double const K : sizes(found)) {
    auto const choice = recommend(found, K, target);
    section.content.emplace_back(Paragraph{
        size_text(K) + (choice ? fmt::format("{}, dt = {:.2g} reduced, limited by {}. Apply it with `{}`.",
                                             short_name(found.configurations[choice->configuration]),
                                             choice->dt, choice->because, settings_text(found, K, *choice))
                               : "no scheme that was tried meets this target.")});
  }
  return section;
}

} // namespace

Report trade_off_report(TradeOff const& found, Target const& target) {
  std::size_t failed = 0, all = 0;
  for (auto const& of : found.configurations)
    for (auto const& trial : of.trials)
      ++all, failed += trial.failed();
  Report report{
      .title = "Cost against accuracy: " + found.scene.title,
      .lead = fmt::format("{} runs of {} particles over {:g} reduced units of time, of which {} could not "
                          "go on.",
                          all, found.scene.particles.N, found.plan.time, failed),
      .verdicts = {},
      .sections = {},
      .provenance = {}};
  if (found.scene.scheme.name == "ssa" || found.scene.features().densities)
    report.sources = {"Faure 2017", "Shardlow 2003"};
  if (target.any())
    report.sections.push_back(recommendation_section(found, target));
  for (double const K : sizes(found))
    report.sections.push_back(size_section(found, K));
  if (!found.scene.features().energies)
    return report;
  report.sections.push_back(
      {"How the drift is measured",
       {Paragraph{
           "The slope of the energy in time is the drift, but the energy also walks at random and the walk "
           "hides small slopes. Both have one cause: the conservative step gets the energy wrong by W, and "
           "as "
           "it keeps volumes in phase space while fluctuation and dissipation keep the canonical law, "
           "<exp(-W/k_B "
           "T)> = 1. So the mean of W is half its variance over k_B T, and the width of the walk gives the "
           "drift where the slope does not. Each run is judged by the better known of the two; by the slope "
           "where they disagree."}}});
  return report;
}

} // namespace mesobridge::workflows
