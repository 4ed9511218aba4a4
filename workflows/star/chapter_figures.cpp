#include "workflows/star/chapter_figures.hpp"
#include "workflows/report/heat_map.hpp"
#include "workflows/star/figure_parts.hpp"
#include <cmath>
#include <numbers>
#include <numeric>

namespace mesobridge::workflows {

namespace {

std::vector<double> normalised(std::vector<double> values) {
  double const n = double(values.size());
  double const mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (double x : values)
    squares += (x - mean) * (x - mean);
  for (double& x : values)
    x = (x - mean) / std::sqrt(squares / n);
  return values;
}

Plot scatter(std::string name, std::string title, std::string x, std::string y, std::vector<double> const& xs,
             std::vector<double> const& ys) {
  auto plot = framed_plot(std::move(name), std::move(title), std::move(x), std::move(y));
  plot.panels[0].legend = Legend::none;
  plot.panels[0].series = {
      {.label = "molecules", .x = normalised(xs), .y = normalised(ys), .y_error = {}, .colour = 0}};
  return plot;
}

} // namespace

Plot figure_3_2(ChapterMelt const& melt) {
  auto plot = framed_plot("fig32", "Momentum of a molecule", "P_x", "P(P_x)");
  auto const& c = melt.correlations;
  auto maxwell = curve_of(fmt::format("Maxwellian, beta = {:.3f}", c.beta.mean), SeriesStyle::lines, 1);
  double const M = melt.star.atoms(), spread = std::sqrt(M / c.beta.mean);
  for (double x : c.P_x.x) {
    maxwell.x.push_back(x);
    maxwell.y.push_back(std::exp(-x * x / (2 * spread * spread)) /
                        (spread * std::sqrt(2 * std::numbers::pi)));
  }
  plot.panels[0].series = {points_of(c.P_x, "melt", 0), maxwell};
  plot.panels[0].y.min = 0;
  return plot;
}

Plot figure_3_3(ChapterMelt const& melt) {
  auto plot = framed_plot("fig33", "Intrinsic energy of a molecule", "U", "P(U)");
  plot.panels[0].legend = Legend::none;
  plot.panels[0].series = {points_of(melt.correlations.P_U, "", 0)};
  return plot;
}

Plot figure_3_4(ChapterMelt const& melt) {
  return scatter("fig34", "One instant", "K (mean 0, variance 1)", "U (mean 0, variance 1)",
                 melt.correlations.K_snapshot, melt.correlations.U_snapshot);
}

std::string figure_3_5(ChapterMelt const& melt) {
  auto const& map = melt.correlations.map;
  HeatMap picture{.title = "|P(K,U) - P(K)P(U)|/P(K,U)",
                  .x_label = "K",
                  .y_label = "U",
                  .value_label = "relative error",
                  .x = map.K,
                  .y = map.U,
                  .value = {},
                  .top = 0.1};
  for (std::size_t bin = 0; bin < map.error.size(); ++bin)
    picture.value.push_back(map.computed[bin] ? std::optional(std::abs(map.error[bin].mean)) : std::nullopt);
  return draw_svg(picture);
}

Plot figure_3_11(ChapterMelt const& melt) {
  return scatter("fig311", "One instant", "local density (mean 0, variance 1)", "U (mean 0, variance 1)",
                 melt.correlations.density_snapshot, melt.correlations.U_snapshot);
}

Plot figure_3_12(ChapterMelt const& melt) {
  auto plot = framed_plot("fig312", "Energy at a given local density", "local density", "<U>^rho/<U> - 1");
  plot.panels[0].series = {points_of(melt.correlations.U_of_density, "U", 0),
                           points_of(melt.correlations.configurational.U_of_density, "configurational", 1)};
  plot.panels[0].level_lines = {0};
  return plot;
}

} // namespace mesobridge::workflows
