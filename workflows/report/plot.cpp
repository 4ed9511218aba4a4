#include "workflows/report/plot.hpp"
#include "md/error.hpp"
#include "workflows/report/gnuplot.hpp"
#include "workflows/report/plot_axes.hpp"
#include "workflows/report/plot_series.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

void check_number(double value, bool logarithmic, Plot const& plot, Series const& series, char axis) {
  if (!std::isfinite(value) || (logarithmic && value <= 0))
    throw PhysicsError(fmt::format("plot '{}', series '{}': {} = {} cannot be drawn on a {} axis", plot.name,
                                   series.label, axis, value, logarithmic ? "logarithmic" : "linear"));
}

void check_series(Plot const& plot, Panel const& panel, Series const& series) {
  bool const sizes = series.x.size() == series.y.size() &&
                     (series.y_error.empty() || series.y_error.size() == series.y.size()) &&
                     (series.style != SeriesStyle::band || !series.y_error.empty());
  if (!sizes)
    throw std::logic_error(fmt::format("plot '{}', series '{}': lengths differ", plot.name, series.label));
  for (double const x : series.x)
    check_number(x, plot.x.logarithmic, plot, series, 'x');
  for (double const y : series.y)
    check_number(y, panel.y.logarithmic, plot, series, 'y');
  for (double const error : series.y_error)
    check_number(error, false, plot, series, 'e');
}

/// Where the panels stand, as fractions of the picture.
struct Layout {
  double left, right, top, bottom;
};

Layout layout_of(Plot const& plot, LegendBox const& legend) {
  constexpr double width = plot_width, height = plot_height;
  return {.left = 104 / width,
          .right = 1 - 24 / width,
          .top = 1 - (plot.title.empty() ? 16 : 42) / height,
          .bottom = (64 + legend.height()) / height};
}

std::string panel_text(Plot const& plot, Axis const& x, LegendBox const& legend, std::size_t number,
                       double top, double bottom) {
  auto const& panel = plot.panels[number];
  bool const last = number + 1 == plot.panels.size();
  std::string text = fmt::format("set tmargin at screen {}\nset bmargin at screen {}\n", top, bottom);
  text += axis_text('x', x) + axis_text('y', y_axis(panel));
  text += marks_of_low_panel(panel, (top - bottom) * plot_height);
  if (!last)
    text += "set xlabel ''\nset format x ''\n";
  text += number == 0 && !plot.title.empty() ? "set title " + escaped(plot.title) + "\n" : "unset title\n";
  std::vector<std::string> drawings;
  for (double const level : panel.level_lines)
    drawings.push_back(fmt::format("{} with lines lw 1 lc rgb '#888888' notitle", level));
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    auto const data = fmt::format("$panel{}_series{}", number, i);
    if (panel.series[i].x.empty())
      continue;
    text += data_text(panel.series[i], data, panel.y.logarithmic);
    drawings.push_back(drawing_text(panel.series[i], data, i));
  }
  if (drawings.empty())
    throw PhysicsError(fmt::format("plot '{}': a panel has nothing to draw", plot.name));
  if (last && legend.rows > 0) {
    text += fmt::format("set key at screen 0.5,{} bottom center vertical Left reverse maxrows {}\n",
                        6.0 / plot_height, legend.rows);
    drawings.insert(drawings.end(), legend.entries.begin(), legend.entries.end());
  } else
    text += "unset key\n";
  return text + fmt::format("plot {}\n", fmt::join(drawings, ", "));
}

std::string script(Plot const& plot) {
  auto const legend = legend_of(plot);
  auto const layout = layout_of(plot, legend);
  std::string text = fmt::format(
      "set encoding utf8\nset terminal svg size {},{} dynamic enhanced font '{},{}' background "
      "rgb 'white' name '{}'\nset multiplot\nset lmargin at screen {}\nset rmargin at screen {}\n",
      plot_width, plot_height, plot_font, plot_font_size, plot.name, layout.left, layout.right);
  text += "set border 3 lw 1 lc rgb '#444444'\nset tics nomirror out scale 0.6 textcolor rgb '#222222'\n"
          "set grid lw 0.7 lc rgb '#e4e4e4'\nset key noopaque samplen 2 spacing 1.15\n";
  constexpr double gap = 14.0 / plot_height;
  double share = 0;
  for (auto const& panel : plot.panels)
    share += panel.height;
  double const free = layout.top - layout.bottom - gap * static_cast<double>(plot.panels.size() - 1);
  auto const x = common_x_axis(plot);
  double top = layout.top;
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    double const bottom = top - free * plot.panels[i].height / share;
    text += panel_text(plot, x, legend, i, top, bottom);
    top = bottom - gap;
  }
  return text + "unset multiplot\n";
}

/// "Isotherms: P* against rho*", for readers of screens.
std::string described(Plot const& plot) {
  std::vector<std::string> what;
  for (auto const& panel : plot.panels)
    if (!panel.y.label.empty())
      what.push_back(panel.y.label);
  return fmt::format("{}: {} against {}", plot.title.empty() ? plot.name : plot.title, fmt::join(what, "; "),
                     plot.x.label);
}

} // namespace

Plot one_panel(std::string name, std::string title, std::string x, std::string y,
               std::vector<double> level_lines) {
  Plot plot{
      .name = std::move(name), .title = std::move(title), .x = {.label = std::move(x)}, .panels = {Panel{}}};
  plot.panels[0].y.label = std::move(y);
  plot.panels[0].level_lines = std::move(level_lines);
  return plot;
}

std::string draw_svg(Plot const& plot) {
  if (plot.panels.empty())
    throw std::logic_error(fmt::format("plot '{}' has no panel", plot.name));
  for (auto const& panel : plot.panels)
    for (auto const& series : panel.series)
      check_series(plot, panel, series);
  return gnuplot_svg(script(plot), plot.name, described(plot));
}

std::string plain(std::string const& text) {
  std::string result;
  for (char const c : text) {
    if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos)
      result += '\\';
    result += c;
  }
  return result;
}

std::vector<std::string> const& palette() {
  static std::vector<std::string> const colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                "#E69F00", "#56B4E9", "#000000"};
  return colours;
}

} // namespace mesobridge::workflows
