#include "workflows/star/chapter_figures.hpp"
#include "workflows/star/figure_parts.hpp"

namespace mesobridge::workflows {

Plot radial_figure(std::string const& name, Melts const& melts) {
  Plot plot{.name = name,
            .title = "Centres of mass of " + melts.front()->star.name() + " molecules",
            .x = {.label = "r"},
            .panels = {Panel{.y = {.label = "g, u"}, .height = 2},
                       Panel{.y = {.label = "u - g"}, .legend = Legend::none, .level_lines = {0}},
                       Panel{.y = {.label = "configurational"}, .legend = Legend::none, .level_lines = {0}}}};
  int colour = 0;
  for (auto const* const melt : melts) {
    auto const& c = melt->correlations;
    auto g = points_of(c.g, density_label(*melt), colour);
    g.style = SeriesStyle::lines;
    g.y_error.clear();
    plot.panels[0].series.push_back(std::move(g));
    plot.panels[0].series.push_back(points_of(c.u, "", colour));
    plot.panels[1].series.push_back(points_of(c.u_minus_g, "", colour));
    plot.panels[2].series.push_back(points_of(c.configurational.u_minus_g, "", colour));
    ++colour;
  }
  return plot;
}

Plot figure_3_10(ChapterMelt const& melt) {
  auto const& c = melt.correlations;
  Plot plot{.name = "fig310",
            .title = "Energies of a pair of " + melt.star.name() + " molecules",
            .x = {.label = "r"},
            .panels = {Panel{.y = {.label = "<U_1 U_2>^r/<U>^2"}, .height = 2, .level_lines = {1}},
                       Panel{.y = {.label = "g(r)"}, .legend = Legend::none}}};
  constexpr double shown = 7; // sigma; beyond it nothing is left
  auto const near = [](cg::Profile const& profile) {
    cg::Profile part;
    for (std::size_t k = 0; k < profile.x.size() && profile.x[k] < shown; ++k)
      part.x.push_back(profile.x[k]), part.y.push_back(profile.y[k]);
    return part;
  };
  auto g = points_of(near(c.g), "", 0);
  g.style = SeriesStyle::lines;
  g.y_error.clear();
  plot.panels[0].series = {points_of(near(c.pair_energy), "U", 0),
                           points_of(near(c.configurational.pair_energy), "configurational", 1)};
  plot.panels[1].series = {std::move(g)};
  return plot;
}

} // namespace mesobridge::workflows
