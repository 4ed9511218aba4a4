#include "fitting/eos/evaluate.hpp"
#include "workflows/lj_to_sdpd/figures.hpp"
#include "workflows/lj_to_sdpd/plan.hpp"
#include "workflows/sdpd/equilibrium_plots.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// A quantity of the runs against their size.
template <class F>
Series against_size(std::string label, std::vector<RunResult> const& runs, int colour, F&& estimate) {
  Series series{.label = std::move(label), .colour = colour};
  for (auto const& run : runs) {
    cg::Estimate const e = estimate(run);
    series.x.push_back(run.settings.K()), series.y.push_back(e.mean), series.y_error.push_back(e.se);
  }
  return series;
}

template <class F>
Series curve_over_sizes(std::string label, std::vector<RunResult> const& runs, int colour, F&& value) {
  Series series{.label = std::move(label), .style = SeriesStyle::dashes, .colour = colour};
  double const low = runs.front().settings.K(), high = runs.back().settings.K();
  for (int k = 0; k <= 60; ++k) {
    double const K = low * std::pow(high / low, k / 60.0);
    series.x.push_back(K), series.y.push_back(value(K));
  }
  return series;
}

/// Something against the size of the particles of the runs.
Plot size_plot(std::string name, std::string title, std::string y, std::vector<RunResult> const& runs,
               std::vector<double> level_lines = {}) {
  auto plot =
      one_panel(std::move(name), std::move(title), "particle size K", std::move(y), std::move(level_lines));
  plot.x.logarithmic = true;
  plot.x.min = runs.front().settings.K() / 1.5, plot.x.max = runs.back().settings.K() * 1.5;
  return plot;
}

std::string size_label(RunResult const& run) {
  return fmt::format("K = {:g}", run.settings.K());
}

fitting::EosState target(RunResult const& run) {
  return std::visit([&](auto const& eos) { return fitting::state_from_temperature(eos, fluid_rho, fluid_T); },
                    run.settings.as<sdpd::Sdpd>().eos);
}

} // namespace

Plot pressure_against_size(ChainResults const& results) {
  auto const& runs = results.fluid;
  auto plot = size_plot("pressureK", "Pressure", "P [GPa]", runs);
  auto in_GPa = [](RunResult const& run) { return run.settings.units().pressure() / 1e9; };
  double const eos = target(runs.front()).P / 1e9;
  plot.panels[0].series = {
      against_size("SDPD, virial", runs, 0,
                   [&](auto const& run) { return scaled(run.equilibrium.P, in_GPa(run)); }),
      against_size("SDPD, mean of the particles' P", runs, 1,
                   [&](auto const& run) { return scaled(run.equilibrium.P_i.mean, in_GPa(run)); }),
      curve_over_sizes("thesis, Table 5.1", runs, 2, [](double K) { return thesis_means(K).pressure; }),
      curve_over_sizes("fitted equation of state", runs, 3, [&](double) { return eos; })};
  return plot;
}

Plot temperatures_against_size(ChainResults const& results) {
  auto const& runs = results.fluid;
  auto plot = size_plot("temperatureK", "Temperatures", "T [K]", runs, {fluid_T});
  plot.panels[0].series = {
      against_size("kinetic", runs, 0,
                   [](auto const& run) { return scaled(run.equilibrium.T_kin, fluid_T); }),
      against_size("internal", runs, 1,
                   [](auto const& run) { return scaled(run.equilibrium.T_int, fluid_T); })};
  return plot;
}

Plot density_against_size(ChainResults const& results) {
  auto const& runs = results.fluid;
  auto plot = size_plot("densityK", "Mean density", "rho [kg/m^3]", runs, {fluid_rho});
  plot.panels[0].series = {
      against_size("SDPD", runs, 0,
                   [](auto const& run) { return scaled(run.equilibrium.rho.mean, fluid_rho); }),
      curve_over_sizes("thesis, Table 5.1", runs, 2, [](double K) { return thesis_means(K).density; })};
  return plot;
}

Plot variances_against_size(ChainResults const& results) {
  auto const& runs = results.fluid;
  auto plot = size_plot("varianceK", "Variances over the particles", "variance", runs);
  plot.panels[0].y.logarithmic = true;
  auto add = [&](std::string const& label, int colour, auto estimate, double ThesisMeans::*member) {
    plot.panels[0].series.push_back(against_size(label, runs, colour, estimate));
    plot.panels[0].series.push_back(
        curve_over_sizes("", runs, colour, [member](double K) { return thesis_variances(K).*member; }));
  };
  auto squared = [](double x) { return x * x; };
  add(
      "energy [(k_B T)^2 per K^2]", 0, [](auto const& run) { return run.equilibrium.eps.variance; },
      &ThesisMeans::energy);
  add(
      "density [(kg/m^3)^2]", 1,
      [&](auto const& run) { return scaled(run.equilibrium.rho.variance, squared(fluid_rho)); },
      &ThesisMeans::density);
  add(
      "pressure [GPa^2]", 2,
      [&](auto const& run) {
        return scaled(run.equilibrium.P_i.variance, squared(run.settings.units().pressure() / 1e9));
      },
      &ThesisMeans::pressure);
  return plot;
}

std::vector<Plot> fluid_distributions(ChainResults const& results) {
  std::vector<LabelledSamples> eps, rho, P;
  for (auto const& run : results.fluid) {
    double const thermal = run.settings.units().boltzmann * run.settings.T * run.settings.K();
    eps.push_back({size_label(run), run.eps, thermal});
    rho.push_back({size_label(run), run.rho, 1});
    P.push_back({size_label(run), run.P, 1e9});
  }
  std::vector<Plot> plots{distribution_plot("fluideps", "Internal energies", "eps / (K k_B T)", eps),
                          distribution_plot("fluidrho", "Densities", "rho [kg/m^3]", rho),
                          distribution_plot("fluidP", "Pressures", "P [GPa]", P)};
  for (auto& plot : plots) { // large particles have narrow, high distributions
    plot.panels[0].y.logarithmic = true;
    for (auto& series : plot.panels[0].series)
      for (std::size_t k = series.y.size(); k-- > 0;)
        if (!(series.y[k] > 0))
          series.x.erase(series.x.begin() + std::ptrdiff_t(k)),
              series.y.erase(series.y.begin() + std::ptrdiff_t(k));
  }
  return plots;
}

std::vector<Plot> ideal_gas_distributions(ChainResults const& results) {
  std::vector<Plot> plots;
  for (auto const& run : results.ideal) {
    double const thermal = run.settings.units().boltzmann * run.settings.T;
    auto plot = distribution_plot(fmt::format("idealK{:g}", run.settings.K()),
                                  fmt::format("Ideal gas, K = {:g}", run.settings.K()), "eps / k_B T",
                                  {{"SDPD", run.eps, thermal}});
    auto const& x = plot.panels[0].series[0].x;
    plot.panels[0].series.push_back(gamma_law(run.settings.K(), x.front(), x.back(), 1));
    plots.push_back(std::move(plot));
  }
  return plots;
}

Plot drift_against_time_step(std::vector<DriftLaw> const& laws) {
  Plot plot{.name = "drift",
            .title = "Energy drift of SSA, ideal gas: ours (points, lines), printed (dashes)",
            .x = {.label = "time step [reduced]", .logarithmic = true, .min = 0.08, .max = 0.5},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y = {.label = "drift rate of E/E_0 [1 / reduced time]", .logarithmic = true};
  int colour = 0;
  for (auto const& law : laws) {
    double const printed = law.K == 10 ? 9.50 : law.K == 50 ? 181 : 217;
    Series points{.label = fmt::format("K = {:g}", law.K), .colour = colour};
    Series ours{.x = {}, .y = {}, .y_error = {}, .style = SeriesStyle::lines, .colour = colour};
    Series theirs{.x = {}, .y = {}, .y_error = {}, .style = SeriesStyle::dashes, .colour = colour};
    for (std::size_t k = 0; k < law.dt.size(); ++k) {
      if (law.rate[k] >
          1.2 * law.se[k]) { // an error bar that reaches zero has no place on a logarithmic axis
        points.x.push_back(law.dt[k]), points.y.push_back(law.rate[k]), points.y_error.push_back(law.se[k]);
      }
      theirs.x.push_back(law.dt[k]), theirs.y.push_back(printed * std::pow(law.dt[k], 5.44));
      ours.x.push_back(law.dt[k]),
          ours.y.push_back(law.prefactor.mean * std::pow(law.dt[k], law.exponent.mean));
    }
    panel.series.push_back(points);
    if (law.exponent.n_eff > 0)
      panel.series.push_back(ours);
    panel.series.push_back(theirs);
    ++colour;
  }
  return plot;
}

} // namespace mesobridge::workflows
