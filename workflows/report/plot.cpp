#include "workflows/report/plot.hpp"
#include "md/error.hpp"
#include "workflows/process.hpp"
#include <algorithm>
#include <array>
#include <limits>

namespace mesobridge::workflows {

namespace {

constexpr int font_size = 14;

std::string escaped(std::string const& text) {
  std::string result;
  for (char const c : text)
    result += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return "'" + result + "'";
}

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

std::string range_text(Axis const& axis) {
  auto const end = [](std::optional<double> value) {
    return value ? fmt::format("{}", *value) : std::string("*");
  };
  return fmt::format("[{}:{}]", end(axis.min), end(axis.max));
}

/// Marks at 1, 2 and 5 for a logarithmic axis of few decades, where gnuplot would mark only one or two
/// numbers.
std::string few_decades_text(char which, Axis const& axis) {
  if (!axis.logarithmic || !axis.min || !axis.max || *axis.max > 1000 * *axis.min)
    return fmt::format("set {}tics auto\n", which);
  std::string marks;
  for (double decade = std::pow(10, std::floor(std::log10(*axis.min))); decade <= *axis.max; decade *= 10)
    for (int const digit : {1, 2, 5})
      marks += fmt::format("{}{:g}", marks.empty() ? "" : ", ", digit * decade);
  return fmt::format("set format {0} '%g'\nset {0}tics ({1})\n", which, marks);
}

/// The x axis with both ends fixed, so that all panels share them: room for all data and a little more.
Axis common_x_axis(Plot const& plot) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (auto const& panel : plot.panels)
    for (auto const& series : panel.series)
      for (double const x : series.x)
        least = std::min(least, x), most = std::max(most, x);
  auto axis = plot.x;
  if (!(least <= most))
    return axis; // no data: the panels will say so
  constexpr double room = 0.03;
  bool const log = axis.logarithmic;
  double const width =
      most > least ? (log ? std::log(most / least) : most - least) : (log ? 1 : std::abs(most) + 1);
  axis.min = axis.min.value_or(log ? least * std::exp(-room * width) : least - room * width);
  axis.max = axis.max.value_or(log ? most * std::exp(room * width) : most + room * width);
  return axis;
}

std::string legend_text(Legend legend) {
  switch (legend) {
  case Legend::top_left:
    return "set key top left Left reverse";
  case Legend::top_right:
    return "set key top right";
  case Legend::bottom_left:
    return "set key bottom left Left reverse";
  case Legend::bottom_right:
    return "set key bottom right";
  case Legend::outside:
    return "set key outside right center Left reverse";
  case Legend::none:
    return "unset key";
  }
  throw std::logic_error("unknown legend");
}

/// The datablock of a series: x, y and, if there are errors, the lower and the upper end of the bar.
std::string data_text(Series const& series, std::string const& name, bool logarithmic) {
  std::string text = name + " << EOD\n";
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    text += fmt::format("{} {}", series.x[i], series.y[i]);
    if (!series.y_error.empty()) {
      double const low = series.y[i] - series.y_error[i];
      // A logarithmic axis has no room for a bar that reaches zero: it ends a decade below its point.
      text += fmt::format(" {} {}", logarithmic && low <= 0 ? series.y[i] / 10 : low,
                          series.y[i] + series.y_error[i]);
    }
    text += "\n";
  }
  return text + "EOD\n";
}

std::string drawing_text(Series const& series, std::string const& data, std::size_t position) {
  static constexpr std::array point_types{7, 5, 9, 13, 11, 15};
  auto const index = static_cast<std::size_t>(series.colour.value_or(static_cast<int>(position)));
  auto const colour = palette()[index % palette().size()];
  auto const title = series.label.empty() ? "notitle" : "title " + escaped(series.label);
  auto const with = [&](std::string const& style) {
    return fmt::format("{} {} lc rgb '{}' {}", data, style, colour, title);
  };
  auto const points = fmt::format("pt {} ps 0.55", point_types[index % point_types.size()]);
  switch (series.style) {
  case SeriesStyle::points:
    if (series.y_error.empty())
      return with("with points " + points);
    // Bars are drawn apart: gnuplot 5.4's own error bars erase what is behind their points.
    return fmt::format("{0} using 1:3:(0):($4-$3) with vectors nohead lw 1.3 lc rgb '{1}' notitle, {2}", data,
                       colour, with("using 1:2 with points " + points));
  case SeriesStyle::lines:
    return with("with lines lw 2");
  case SeriesStyle::dashes:
    return with("with lines lw 2 dt (8,6)");
  case SeriesStyle::steps:
    return with("with histeps lw 1.8");
  case SeriesStyle::band:
    return with("using 1:3:4 with filledcurves fs transparent solid 0.18 noborder");
  }
  throw std::logic_error("unknown style");
}

/// Where the panels stand, as fractions of the picture.
struct Layout {
  double left, right, top, bottom;
};

/// Room to the right of the panels: for the longest label, where a legend stands there, but never more than
/// half of the picture.
double right_margin(Plot const& plot) {
  constexpr double sample_and_gaps = 64, letter = 7.4;
  double room = 24;
  for (auto const& panel : plot.panels)
    if (panel.legend == Legend::outside)
      for (auto const& series : panel.series)
        room = std::max({room, 190.0, sample_and_gaps + letter * static_cast<double>(series.label.size())});
  return std::min(room, 0.5 * plot.width);
}

Layout layout_of(Plot const& plot) {
  double const width = plot.width, height = plot.height;
  return {.left = 88 / width,
          .right = 1 - right_margin(plot) / width,
          .top = 1 - (plot.title.empty() ? 16 : 40) / height,
          .bottom = 64 / height};
}

std::string axis_text(char which, Axis const& axis) {
  std::string text = fmt::format("set {}label {}{}\nset {}range {}\n", which, escaped(axis.label),
                                 which == 'x' ? " offset 0,0.4" : "", which, range_text(axis));
  text += axis.logarithmic ? fmt::format("set logscale {0}\nset format {0} '10^{{%T}}'\n", which)
                           : fmt::format("unset logscale {0}\nset format {0} '%h'\n", which);
  return text + few_decades_text(which, axis);
}

std::string panel_text(Plot const& plot, Axis const& x, Panel const& panel, std::size_t number, double top,
                       double bottom) {
  bool const last = number + 1 == plot.panels.size();
  std::string text = fmt::format("set tmargin at screen {}\nset bmargin at screen {}\n", top, bottom);
  text += axis_text('x', x) + axis_text('y', panel.y);
  if (!last)
    text += "set xlabel ''\nset format x ''\n";
  text += number == 0 && !plot.title.empty() ? "set title " + escaped(plot.title) + "\n" : "unset title\n";
  text += legend_text(panel.legend) + "\n";
  std::string drawings;
  for (double const level : panel.level_lines)
    drawings +=
        fmt::format("{}{} with lines lw 1 lc rgb '#888888' notitle", drawings.empty() ? "" : ", ", level);
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    auto const data = fmt::format("$panel{}_series{}", number, i);
    if (panel.series[i].x.empty())
      continue;
    text += data_text(panel.series[i], data, panel.y.logarithmic);
    drawings += (drawings.empty() ? "" : ", ") + drawing_text(panel.series[i], data, i);
  }
  if (drawings.empty())
    throw PhysicsError(fmt::format("plot '{}': a panel has nothing to draw", plot.name));
  return text + "plot " + drawings + "\n";
}

std::string script(Plot const& plot) {
  auto const layout = layout_of(plot);
  std::string text = fmt::format(
      "set encoding utf8\nset terminal svg size {},{} dynamic enhanced font 'Arial,{}' background "
      "rgb 'white' name '{}'\nset multiplot\nset lmargin at screen {}\nset rmargin at screen {}\n",
      plot.width, plot.height, font_size, plot.name, layout.left, layout.right);
  text += "set border 3 lw 1 lc rgb '#444444'\nset tics nomirror out scale 0.6 textcolor rgb '#222222'\n"
          "set grid lw 0.7 lc rgb '#e4e4e4'\nset key noopaque samplen 2 spacing 1.15\n";
  double const gap = 14.0 / plot.height;
  double share = 0;
  for (auto const& panel : plot.panels)
    share += panel.height;
  double const free = layout.top - layout.bottom - gap * static_cast<double>(plot.panels.size() - 1);
  auto const x = common_x_axis(plot);
  double top = layout.top;
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    double const bottom = top - free * plot.panels[i].height / share;
    text += panel_text(plot, x, plot.panels[i], i, top, bottom);
    top = bottom - gap;
  }
  return text + "unset multiplot\n";
}

} // namespace

std::string draw_svg(Plot const& plot) {
  if (plot.panels.empty())
    throw std::logic_error(fmt::format("plot '{}' has no panel", plot.name));
  for (auto const& panel : plot.panels)
    for (auto const& series : panel.series)
      check_series(plot, panel, series);
  auto const result = run_process({"gnuplot", "-d"}, script(plot));
  auto const start = result.output.find("<svg");
  if (result.status != 0 || start == std::string::npos || !result.output.ends_with("</svg>\n\n"))
    throw EnvironmentError(
        fmt::format("gnuplot could not draw '{}': {}", plot.name,
                    result.errors.empty() ? "it wrote no complete picture" : result.errors));
  return result.output.substr(start);
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
