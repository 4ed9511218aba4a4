#include "workflows/reproduce/ideal_gas_study.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {
namespace {

constexpr double settle = 10; ///< reduced time after the change to a trial's scheme

cg::Estimate rate(sdpd::Drift const& drift) {
  return {drift.rate, drift.se, 8};
}

std::string file_name(std::string const& label, double dt) {
  std::string name;
  for (char const c : label)
    if (std::isalnum(static_cast<unsigned char>(c)))
      name += c;
  return fmt::format("{}-dt{:g}", name, dt);
}

} // namespace

Scene thesis_ideal_gas(double K, std::string const& scheme, std::uint64_t seed) {
  Scene scene;
  scene.title = "Ideal gas";
  scene.fluid = {.eos = "ideal-gas", .rho = 1150, .T = 1000, .m0 = 1e-25};
  scene.particles.K = K;
  scene.particles.kernel = "cubic", scene.particles.density = "plain"; // the thesis's
  scene.transport.eta = 2e-3;
  scene.scheme.name = scheme;
  scene.run.seed = static_cast<std::int64_t>(seed);
  return scene;
}

std::pair<std::vector<double>, std::vector<cg::Estimate>> LineResult::drifts() const {
  std::pair<std::vector<double>, std::vector<cg::Estimate>> result;
  for (std::size_t k = 0; k < dt.size(); ++k)
    if (trials[k].knows_drift())
      result.first.push_back(dt[k]), result.second.push_back(rate(trials[k].drift()));
  return result;
}

fitting::PowerLaw LineResult::drift_law() const {
  std::vector<double> x;
  std::vector<cg::Estimate> y;
  for (std::size_t k = 0; k < dt.size(); ++k)
    if (!trials[k].failed() && trials[k].knows_drift())
      x.push_back(dt[k]), y.push_back(rate(trials[k].drift()));
  return fitting::fit_power_law(x, y);
}

RunLength run_length_of(md::Preset preset) {
  switch (preset) {
  case md::Preset::quick:
    return {1, 343};
  case md::Preset::standard:
    return {20, 1000};
  case md::Preset::paper:
    break;
  }
  return {200, 1000};
}

std::vector<LineResult> run_lines(std::string const& title, std::vector<StudyLine> const& lines,
                                  ReproduceOptions const& options, Context const& context) {
  auto const run_length = run_length_of(options.preset);
  std::vector<PlannedTrial> plan;
  for (auto const& line : lines)
    for (double const dt : line.dt) {
      Scene scene = small_sample(line.scene, run_length.particles);
      set_times(scene, dt, settle, run_length.length * line.time);
      plan.push_back({file_name(line.label, dt), scene, line.bins});
    }
  auto const directory = options.directory / "trials";
  std::error_code ignored;
  std::filesystem::create_directories(directory, ignored); // writing there says what is wrong
  auto progress = context.progress(title, 1);
  auto results = run_study(plan, {.directory = directory,
                                  .threads = options.threads,
                                  .keep_going = [&](double share, std::string const& name) {
                                    progress.update(share, name);
                                    return !interrupt_requested();
                                  }});
  progress.finish();
  std::vector<LineResult> found;
  auto result = results.begin();
  for (auto const& line : lines) {
    LineResult of{.label = line.label, .dt = line.dt, .trials = {}};
    for (std::size_t k = 0; k < line.dt.size(); ++k)
      of.trials.push_back(std::move(*result++));
    found.push_back(std::move(of));
  }
  return found;
}

Series resolved_points(std::string label, std::vector<double> const& x, std::vector<cg::Estimate> const& y,
                       int colour) {
  Series series{.label = std::move(label), .colour = colour};
  for (std::size_t k = 0; k < x.size(); ++k)
    if (y[k].mean > y[k].se)
      series.x.push_back(x[k]), series.y.push_back(y[k].mean), series.y_error.push_back(y[k].se);
  return series;
}

Plot over_time_step(std::string name, std::string title, std::string y, bool logarithmic) {
  Plot plot{.name = std::move(name),
            .title = std::move(title),
            .x = {.label = "time step [reduced]", .logarithmic = true},
            .panels = {Panel{}}};
  plot.panels[0].y = {.label = std::move(y), .logarithmic = logarithmic};
  return plot;
}

Plot energy_in_time(std::string name, std::string title, std::vector<LineResult> const& lines) {
  auto plot = one_panel(std::move(name), std::move(title), "time [reduced]", "10^4 (E - E_0)/|E_0|", {0});
  for (auto const& line : lines)
    for (std::size_t k = 0; k < line.dt.size(); ++k) {
      if (line.trials[k].failed())
        continue;
      Series series{.label = fmt::format("{}, dt = {:g}", line.label, line.dt[k]),
                    .x = line.trials[k].times,
                    .style = SeriesStyle::lines};
      for (double const error : line.trials[k].energies)
        series.y.push_back(1e4 * error);
      plot.panels[0].series.push_back(std::move(series));
    }
  return plot;
}

Json lines_json(std::vector<LineResult> const& lines) {
  Json json = Json::array();
  for (auto const& line : lines) {
    Json one{{"label", line.label}};
    if (auto const law = line.drift_law(); law.known())
      put(one, "drift_exponent", law.exponent);
    for (std::size_t k = 0; k < line.dt.size(); ++k) {
      auto const& trial = line.trials[k];
      Json row{{"dt_reduced", line.dt[k]}};
      if (trial.knows_drift()) {
        put(row, "energy_drift_per_reduced_time", rate(trial.drift()));
        put(row, "energy_drift_of_mean_per_reduced_time", rate(trial.drift_of_mean));
      }
      if (trial.failed()) {
        row["failure"] = trial.failure;
      } else {
        put(row, "T_kin_reduced", trial.T_kin), put(row, "T_int_reduced", trial.T_int);
        put(row, "eps_variance_kT2", trial.eps_variance);
        row["rejected_out_of_domain"] = trial.rejected_out_of_domain;
        row["rejected_metropolis"] = trial.rejected_metropolis;
      }
      one["trials"].push_back(row);
    }
    json.push_back(one);
  }
  return json;
}

Table drift_table(std::vector<LineResult> const& lines) {
  Table table{
      .header = {"scheme and size", "dt", "drift [1/time]", "by the slope", "by the walk", "rejected [%]"},
      .caption =
          "Rates of (E - E_0)/|E_0| in reduced units: by the slope of the energy, and by the width of "
          "its random walk, <W> = Var(W)/2 k_B T; the first column takes the better known one. Both look "
          "at the time in which the temperature changes by 2 % at most. The power laws leave out "
          "runs that fail later."};
  for (auto const& line : lines)
    for (std::size_t k = 0; k < line.dt.size(); ++k) {
      auto const& trial = line.trials[k];
      if (!trial.knows_drift())
        table.rows.push_back({line.label, number_text(line.dt[k], 3),
                              trial.failed() ? "fails" : "heats too fast", "", "", ""});
      else
        table.rows.push_back(
            {line.label, number_text(line.dt[k], 3), with_error_text(rate(trial.drift())),
             with_error_text(rate(trial.drift_of_mean)),
             trial.drift_of_walk.se > 0 ? with_error_text(rate(trial.drift_of_walk)) : "-",
             trial.failed()
                 ? "fails later"
                 : number_text(100 * (trial.rejected_out_of_domain + trial.rejected_metropolis), 2)});
    }
  return table;
}

std::vector<std::string> failures(std::vector<LineResult> const& lines) {
  std::vector<std::string> found;
  for (auto const& line : lines)
    for (std::size_t k = 0; k < line.dt.size(); ++k)
      if (line.trials[k].failed())
        found.push_back(fmt::format("{}, dt = {:g}: {}", line.label, line.dt[k], line.trials[k].failure));
  return found;
}

} // namespace mesobridge::workflows
