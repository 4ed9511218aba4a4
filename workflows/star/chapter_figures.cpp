#include "workflows/star/chapter_figures.hpp"
#include "workflows/report/heat_map.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mesobridge::workflows {

namespace {

constexpr int half_width = 480, half_height = 360;

Plot half_plot(std::string name, std::string title, std::string x, std::string y) {
  Plot plot{.name = std::move(name),
            .title = std::move(title),
            .x = {.label = std::move(x)},
            .panels = {Panel{}},
            .width = half_width,
            .height = half_height};
  plot.panels[0].y.label = std::move(y);
  return plot;
}

Series points_of(cg::Profile const& profile, std::string label, int colour) {
  Series series{.label = std::move(label), .x = profile.x, .y = {}, .y_error = {}, .colour = colour};
  for (auto const& y : profile.y) {
    series.y.push_back(y.mean);
    series.y_error.push_back(y.se);
  }
  return series;
}

Series curve_of(std::string label, SeriesStyle style, int colour) {
  return {.label = std::move(label), .x = {}, .y = {}, .y_error = {}, .style = style, .colour = colour};
}

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
  auto plot = half_plot(std::move(name), std::move(title), std::move(x), std::move(y));
  plot.panels[0].legend = Legend::none;
  plot.panels[0].series = {
      {.label = "molecules", .x = normalised(xs), .y = normalised(ys), .y_error = {}, .colour = 0}};
  return plot;
}

/// A number of a curve, with its error, over the energies of the melt.
Series entropy_series(EntropyRoutes const& routes, std::string const& route, std::string label,
                      SeriesStyle style, int colour,
                      std::function<double(cg::EntropyCurve const&, double)> const& number) {
  auto series = curve_of(std::move(label), style, colour);
  if (auto const* const curve = routes.curve(route))
    for (double U : routes.U) {
      auto const estimate = curve->fit.estimate([&](auto const& c) { return number(c, U); });
      series.x.push_back(U);
      series.y.push_back(estimate.mean);
      if (style == SeriesStyle::points || style == SeriesStyle::band)
        series.y_error.push_back(estimate.se);
    }
  return series;
}

std::string melt_label(ChapterMelt const& melt) {
  return fmt::format("{}, rho = {}", melt.star.name(), melt.rho);
}

} // namespace

Plot figure_3_2(ChapterMelt const& melt) {
  auto plot = half_plot("fig32", "Momentum of a molecule", "P_x", "P(P_x)");
  auto const& c = melt.correlations;
  auto maxwell = curve_of(fmt::format("Maxwellian, beta = {:.3f}", c.beta.mean), SeriesStyle::lines, 1);
  double const M = melt.star.atoms(), spread = std::sqrt(M / c.beta.mean);
  for (double x : c.P_x.x) {
    maxwell.x.push_back(x);
    maxwell.y.push_back(std::exp(-x * x / (2 * spread * spread)) /
                        (spread * std::sqrt(2 * std::numbers::pi)));
  }
  plot.panels[0].series = {points_of(c.P_x, "melt", 0), maxwell};
  return plot;
}

Plot figure_3_3(ChapterMelt const& melt) {
  auto plot = half_plot("fig33", "Intrinsic energy of a molecule", "U", "P(U)");
  plot.panels[0].series = {points_of(melt.correlations.P_U, melt_label(melt), 0)};
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

Plot entropy_figure(std::string const& name, std::vector<ChapterMelt const*> const& melts) {
  auto plot = half_plot(name, "Entropy of a molecule", "U", "S(U)/k_B");
  auto& series = plot.panels[0].series;
  int colour = 0;
  for (auto const* const melt : melts) {
    double const zero = melt->entropy.U_mean;
    auto const S = [zero](cg::EntropyCurve const& c, double U) { return c.S(U) - c.S(zero); };
    series.push_back(
        entropy_series(melt->entropy, "melt", "melt, " + melt_label(*melt), SeriesStyle::dashes, colour, S));
    series.push_back(entropy_series(melt->entropy, "vacuum", "vacuum, " + melt->star.name(),
                                    SeriesStyle::lines, colour + 1, S));
    colour += 2;
  }
  return plot;
}

Plot figure_3_7(std::vector<ChapterMelt const*> const& melts) {
  auto plot = half_plot("fig37", "Temperature of a molecule", "U", "k_B T(U)");
  auto& series = plot.panels[0].series;
  auto const T = [](cg::EntropyCurve const& c, double U) { return c.T(U); };
  int colour = 1;
  for (auto const* const melt : melts) {
    series.push_back(
        entropy_series(melt->entropy, "melt", melt_label(*melt), SeriesStyle::dashes, colour++, T));
  }
  auto const& first = melts.front()->entropy;
  series.push_back(entropy_series(first, "vacuum", "vacuum", SeriesStyle::lines, 0, T));
  if (first.equipartition) {
    auto thesis = curve_of("vacuum, equipartition", SeriesStyle::lines, colour);
    for (double U : first.U) {
      thesis.x.push_back(U);
      thesis.y.push_back(first.equipartition->T(U).mean);
    }
    series.push_back(std::move(thesis));
  }
  return plot;
}

Plot figure_3_8(std::vector<ChapterMelt const*> const& melts) {
  auto plot = half_plot("fig38", "Heat capacity of a molecule", "rho", "C/k_B");
  Series melt{.label = "melt", .x = {}, .y = {}, .y_error = {}, .colour = 0}, vacuum = melt;
  vacuum.label = "vacuum", vacuum.colour = 1;
  for (auto const* const one : melts) {
    auto const add = [&](Series& series, char const* route, double shift) {
      auto const C = one->entropy.curve(route)->C;
      series.x.push_back(one->rho + shift);
      series.y.push_back(C.mean);
      series.y_error.push_back(C.se);
    };
    add(melt, "melt", 0);
    add(vacuum, "vacuum", 0.002); // side by side
  }
  plot.panels[0].series = {melt, vacuum};
  return plot;
}

Plot radial_figure(std::string const& name, std::vector<ChapterMelt const*> const& melts) {
  Plot plot{.name = name,
            .title = "Centres of mass: g(r), u(r) and their difference",
            .x = {.label = "r"},
            .panels = {Panel{.height = 2}, Panel{}},
            .width = 760,
            .height = 520};
  plot.panels[0].y.label = "g, u";
  plot.panels[0].legend = Legend::bottom_right;
  plot.panels[1].y.label = "u - g";
  plot.panels[1].level_lines = {0};
  plot.panels[1].legend = Legend::none;
  int colour = 0;
  for (auto const* const melt : melts) {
    auto const& c = melt->correlations;
    auto g = points_of(c.g, "g, " + melt_label(*melt), colour);
    g.style = SeriesStyle::lines;
    g.y_error.clear();
    plot.panels[0].series.push_back(std::move(g));
    plot.panels[0].series.push_back(points_of(c.u, "u, " + melt_label(*melt), colour + 1));
    plot.panels[1].series.push_back(points_of(c.u_minus_g, "", colour));
    colour += 2;
  }
  return plot;
}

Plot figure_3_10(ChapterMelt const& melt) {
  auto plot = half_plot("fig310", "Energies of a pair of molecules", "r", "<U_1 U_2>^r/<U>^2, g");
  auto const& c = melt.correlations;
  cg::Profile near;
  Series g{.label = "g(r)", .x = {}, .y = {}, .y_error = {}, .style = SeriesStyle::lines, .colour = 1};
  constexpr double shown = 4; // sigma; the thesis shows the near range
  for (std::size_t k = 0; k < c.pair_energy.x.size() && c.pair_energy.x[k] < shown; ++k) {
    near.x.push_back(c.pair_energy.x[k]);
    near.y.push_back(c.pair_energy.y[k]);
    g.x.push_back(c.g.x[k]);
    g.y.push_back(c.g.y[k].mean);
  }
  plot.panels[0].series = {points_of(near, "<U_1 U_2>^r/<U>^2", 0), g};
  plot.panels[0].level_lines = {1};
  return plot;
}

Plot figure_3_11(ChapterMelt const& melt) {
  return scatter("fig311", "One instant", "local density (mean 0, variance 1)", "U (mean 0, variance 1)",
                 melt.correlations.density_snapshot, melt.correlations.U_snapshot);
}

Plot figure_3_12(ChapterMelt const& melt) {
  auto plot = half_plot("fig312", "Energy at a given local density", "local density", "<U>^rho/<U> - 1");
  plot.panels[0].series = {points_of(melt.correlations.U_of_density, melt_label(melt), 0)};
  plot.panels[0].level_lines = {0};
  return plot;
}

} // namespace mesobridge::workflows
