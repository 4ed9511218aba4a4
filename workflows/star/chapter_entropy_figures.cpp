#include "workflows/star/chapter_figures.hpp"
#include "workflows/star/figure_parts.hpp"
#include <map>

namespace mesobridge::workflows {

namespace {

constexpr double highest_density = 0.6; // of the axes
constexpr double side_by_side = 0.006;  // shift of points that would hide each other

/// A number of a curve, with its error, over the energies of the melt.
Series entropy_series(cg::EntropyRoutes const& routes, std::string const& route, std::string label,
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

} // namespace

Plot entropy_figure(std::string const& name, Melts const& melts) {
  auto plot = framed_plot(name, "Entropy of a " + melts.front()->star.name() + " molecule", "U", "S(U)/k_B");
  plot.panels = {Panel{.y = {.label = "S(U)/k_B"}, .height = 1.5},
                 Panel{.y = {.label = "melt - vacuum"}, .legend = Legend::none, .level_lines = {0}}};
  auto const& first = melts.front()->entropy;
  double const zero = first.U_mean; // S is known but for a constant
  auto const S = [zero](cg::EntropyCurve const& c, double U) { return c.S(U) - c.S(zero); };
  auto& curves = plot.panels[0].series;
  curves.push_back(entropy_series(first, "vacuum", "vacuum", SeriesStyle::lines, 0, S));
  int colour = 1;
  for (auto const* const melt : melts) {
    auto curve = entropy_series(melt->entropy, "melt", density_label(*melt), SeriesStyle::dashes, colour, S);
    auto difference = curve_of("", SeriesStyle::lines, colour++);
    difference.x = curve.x;
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      difference.y.push_back(curve.y[k] - S(melt->entropy.curve("vacuum")->fit.curve, curve.x[k]));
    curves.push_back(std::move(curve));
    plot.panels[1].series.push_back(std::move(difference));
  }
  return plot;
}

Plot figure_3_7(Melts const& melts) {
  auto plot = framed_plot("fig37", "Temperature of a molecule", "U", "k_B T(U)");
  auto& series = plot.panels[0].series;
  auto const T = [](cg::EntropyCurve const& c, double U) { return c.T(U); };
  int colour = 1;
  for (auto const* const melt : melts) {
    series.push_back(
        entropy_series(melt->entropy, "melt", density_label(*melt), SeriesStyle::dashes, colour++, T));
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

Plot figure_3_8(Melts const& melts) {
  auto plot =
      framed_plot("fig38", "Heat capacity of a " + melts.front()->star.name() + " molecule", "rho", "C/k_B");
  plot.x.min = 0, plot.x.max = highest_density;
  struct Route {
    char const *name, *label;
  };
  int colour = 0;
  for (auto const& [name, label] :
       {Route{"melt", "melt"}, Route{"vacuum", "vacuum"}, Route{"melt_kinetic", "melt, kinetic"},
        Route{"vacuum_kinetic", "vacuum, kinetic"}}) {
    Series series{.label = label, .colour = colour};
    for (auto const* const melt : melts) {
      auto const C = melt->entropy.curve(name)->C;
      series.x.push_back(melt->rho + side_by_side * colour);
      series.y.push_back(C.mean);
      series.y_error.push_back(C.se);
    }
    plot.panels[0].series.push_back(std::move(series));
    ++colour;
  }
  return plot;
}

Plot heat_capacity_differences(Melts const& melts) {
  auto plot =
      framed_plot("fig38b", "Heat capacity: melt against vacuum", "rho", "C_{melt}/C_{vacuum} - 1 [%]");
  plot.x.min = 0, plot.x.max = highest_density;
  plot.panels[0].level_lines = {-5, 0, 5};              // the thesis's bounds
  plot.panels[0].y.min = -8, plot.panels[0].y.max = 12; // the legend stands above
  std::map<int, Series> of_star;
  for (auto const* const melt : melts) {
    auto const difference = heat_capacity_difference(*melt);
    auto& series = of_star[melt->star.beads];
    series.label = melt->star.name();
    series.x.push_back(melt->rho + side_by_side * double(of_star.size() - 1));
    series.y.push_back(100 * difference.mean);
    series.y_error.push_back(100 * difference.se);
  }
  for (auto& [beads, series] : of_star)
    plot.panels[0].series.push_back(std::move(series));
  return plot;
}

} // namespace mesobridge::workflows
