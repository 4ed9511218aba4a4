#include "workflows/sdpd/equilibrium_plots.hpp"
#include "cg/histogram.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include <algorithm>
#include <gsl/gsl_randist.h>

namespace mesobridge::workflows {

Plot distribution_plot(std::string const& name, std::string const& title, std::string const& axis,
                       std::vector<LabelledSamples> const& samples) {
  auto plot = one_panel(name, title, axis, "probability density");
  for (auto const& [label, values, unit] : samples) {
    std::vector<double> scaled(values.begin(), values.end());
    for (auto& value : scaled)
      value /= unit;
    auto const [low, high] = std::minmax_element(scaled.begin(), scaled.end());
    double const margin = 1e-9 * (std::abs(*low) + std::abs(*high)) + 1e-300;
    auto const histogram = cg::histogram(scaled, *low - margin, *high + margin, 60);
    Series series{
        .label = label, .x = {}, .y = histogram.density, .y_error = {}, .style = SeriesStyle::steps};
    for (std::size_t bin = 0; bin < histogram.density.size(); ++bin)
      series.x.push_back(histogram.centre(bin));
    plot.panels[0].series.push_back(std::move(series));
  }
  return plot;
}

Plot energy_error_plot(std::string const& name,
                       std::vector<std::pair<std::string, RunResult const*>> const& runs) {
  auto plot = one_panel(name, "Energy error", "time [reduced]", "10^6 (E - E_0)/E_0", {0});
  for (auto const& [label, run] : runs) {
    std::vector<double> error;
    for (double const energy : run->energies)
      error.push_back(1e6 * (energy / run->energies.front() - 1));
    constexpr std::size_t most_points = 400;
    Series series{.label = label,
                  .x = thinned(run->times, most_points),
                  .y = thinned(error, most_points),
                  .style = SeriesStyle::lines};
    plot.panels[0].series.push_back(std::move(series));
  }
  return plot;
}

Series gamma_law(double K, double x_min, double x_max, int colour) {
  Series series{
      .label = fmt::format("Gamma law, K = {:g}", K), .style = SeriesStyle::lines, .colour = colour};
  for (int k = 0; k <= 200; ++k) {
    double const x = x_min + (x_max - x_min) * k / 200;
    series.x.push_back(x);
    series.y.push_back(gsl_ran_gamma_pdf(x, 1.5 * (K - 1), 1));
  }
  return series;
}

} // namespace mesobridge::workflows
