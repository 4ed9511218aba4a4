#include "workflows/report/plot.hpp"
#include "md/error.hpp"
#include "workflows/process.hpp"
#include "workflows/report/report.hpp"
#include <algorithm>
#include <array>
#include <limits>

namespace mesobridge::workflows {

namespace {

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

/// Marks at 1, 2 and 5 for a logarithmic axis of few decades, and at more digits for one, where gnuplot would
/// mark only one or two numbers.
std::string few_decades_text(char which, Axis const& axis) {
  if (!axis.logarithmic || !axis.min || !axis.max || *axis.max > 1000 * *axis.min)
    return fmt::format("set {}tics auto\n", which);
  auto const digits = *axis.max > 12 * *axis.min ? std::vector{1, 2, 5} : std::vector{1, 2, 3, 4, 5, 6, 8};
  std::string marks;
  for (double decade = std::pow(10, std::floor(std::log10(*axis.min))); decade <= *axis.max; decade *= 10)
    for (int const digit : digits)
      marks += fmt::format("{}{:g}", marks.empty() ? "" : ", ", digit * decade);
  return fmt::format("set format {0} '%g'\nset {0}tics ({1})\n", which, marks);
}

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  void add(double value) { least = std::min(least, value), most = std::max(most, value); }
};

/// The axis with both ends fixed where the range has data: room for all of them and a little more.
Axis with_room(Axis axis, Range const& range, double room) {
  auto const [least, most] = range;
  if (!(least <= most))
    return axis; // no data: the panels will say so
  bool const log = axis.logarithmic;
  double const width =
      most > least ? (log ? std::log(most / least) : most - least) : (log ? 1 : std::abs(most) + 1);
  axis.min = axis.min.value_or(log ? least * std::exp(-room * width) : least - room * width);
  axis.max = axis.max.value_or(log ? most * std::exp(room * width) : most + room * width);
  return axis;
}

/// The distance of marks on a linear axis over that range, 1, 2 or 5 times a power of ten, so that at most
/// `most` of them fit.
double mark_distance(Range const& range, double most) {
  double const least = (range.most - range.least) / std::max(most - 1, 1.0);
  double const decade = std::pow(10, std::floor(std::log10(least)));
  for (double const factor : {1.0, 2.0, 5.0})
    if (factor * decade >= least)
      return factor * decade;
  return 10 * decade;
}

/// All panels share it.
Axis common_x_axis(Plot const& plot) {
  Range range;
  for (auto const& panel : plot.panels)
    for (auto const& series : panel.series)
      for (double const x : series.x)
        range.add(x);
  return with_room(plot.x, range, 0.03);
}

Range y_range(Panel const& panel) {
  Range range;
  for (double const level : panel.level_lines)
    range.add(level);
  for (auto const& series : panel.series)
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      double const error = series.y_error.empty() ? 0 : series.y_error[i];
      range.add(series.y[i] - error), range.add(series.y[i] + error);
    }
  return range;
}

/// Fewer marks for low panels, whose numbers would run into each other.
std::string marks_of_low_panel(Panel const& panel, double height) {
  constexpr double high_enough = 180, room_of_a_number = 26; // [px]
  auto const range = y_range(panel);
  if (height >= high_enough || panel.y.logarithmic || !(range.least < range.most))
    return "";
  return fmt::format("set ytics {:.15g}\n", mark_distance(range, std::max(2.0, height / room_of_a_number)));
}

/// gnuplot's own choice ends at marks, which suits linear axes; a logarithmic one would end at its outermost
/// points or a decade beyond them.
Axis y_axis(Panel const& panel) {
  if (!panel.y.logarithmic)
    return panel.y;
  Range range;
  for (auto const& series : panel.series)
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      double const y = series.y[i], error = series.y_error.empty() ? 0 : series.y_error[i];
      range.add(std::max(y - error, y / 3)), range.add(y + error);
    }
  return with_room(panel.y, range, 0.06);
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

/// A series as it stands in the legend: gnuplot's words without data.
std::string style_text(Series const& series, std::size_t position) {
  static constexpr std::array point_types{7, 5, 9, 13, 11, 15};
  auto const index = static_cast<std::size_t>(series.colour.value_or(static_cast<int>(position)));
  auto const colour = palette()[index % palette().size()];
  switch (series.style) {
  case SeriesStyle::points:
    return fmt::format("with points pt {} ps 0.7 lc rgb '{}'", point_types[index % point_types.size()],
                       colour);
  case SeriesStyle::lines:
    return fmt::format("with lines lw 2 lc rgb '{}'", colour);
  case SeriesStyle::dashes:
    return fmt::format("with lines lw 2 dt (8,6) lc rgb '{}'", colour);
  case SeriesStyle::steps:
    return fmt::format("with lines lw 1.8 lc rgb '{}'", colour);
  case SeriesStyle::band:
    return fmt::format("with boxes fs transparent solid 0.18 noborder lc rgb '{}'", colour);
  }
  throw std::logic_error("unknown style");
}

std::string drawing_text(Series const& series, std::string const& data, std::size_t position) {
  auto const index = static_cast<std::size_t>(series.colour.value_or(static_cast<int>(position)));
  auto const colour = palette()[index % palette().size()];
  auto const drawn = [&](std::string const& how) { return fmt::format("{} {} notitle", data, how); };
  switch (series.style) {
  case SeriesStyle::points:
    if (series.y_error.empty())
      return drawn(style_text(series, position));
    // Bars are drawn apart: gnuplot 5.4's own error bars erase what is behind their points.
    return fmt::format("{0} using 1:3:(0):($4-$3) with vectors nohead lw 1.3 lc rgb '{1}' notitle, {2}", data,
                       colour, drawn("using 1:2 " + style_text(series, position)));
  case SeriesStyle::steps:
    return drawn(fmt::format("with histeps lw 1.8 lc rgb '{}'", colour));
  case SeriesStyle::band:
    return drawn(
        fmt::format("using 1:3:4 with filledcurves fs transparent solid 0.18 noborder lc rgb '{}'", colour));
  case SeriesStyle::lines:
  case SeriesStyle::dashes:
    return drawn(style_text(series, position));
  }
  throw std::logic_error("unknown style");
}

/// Letters that a reader sees of a text with gnuplot's marks.
std::size_t letters(std::string const& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
    bool const continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80; // of a UTF-8 character
    return !continues && std::string_view("{}^_@&~\\").find(c) == std::string_view::npos;
  }));
}

/// What stands under the panels: the labels of all of them, in columns.
struct LegendBox {
  std::vector<std::string> entries; ///< gnuplot's words
  std::size_t rows = 0;
  static constexpr double row_height = 22; ///< [px]
  double height() const { return rows == 0 ? 0 : 16 + row_height * static_cast<double>(rows); }
};

LegendBox legend_of(Plot const& plot) {
  constexpr double sample_and_gaps = 74, letter = 0.52 * plot_font_size;
  LegendBox box;
  std::size_t longest = 0;
  for (auto const& panel : plot.panels)
    for (std::size_t i = 0; i < panel.series.size() && panel.legend == Legend::below; ++i) {
      auto const& series = panel.series[i];
      if (series.label.empty() || series.x.empty())
        continue;
      longest = std::max(longest, letters(series.label));
      box.entries.push_back(
          fmt::format("keyentry {} title {}", style_text(series, i), escaped(series.label)));
    }
  double const entry = sample_and_gaps + letter * static_cast<double>(longest);
  auto const columns = std::max<std::size_t>(1, static_cast<std::size_t>(plot_width / entry));
  box.rows = (box.entries.size() + columns - 1) / columns;
  return box;
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

std::string axis_text(char which, Axis const& axis) {
  std::string text = fmt::format("set {}label {}{}\nset {}range {}\n", which, escaped(axis.label),
                                 which == 'x' ? " offset 0,0.4" : " offset 0.8,0", which, range_text(axis));
  text += axis.logarithmic ? fmt::format("set logscale {0}\nset format {0} '10^{{%T}}'\n", which)
                           : fmt::format("unset logscale {0}\nset format {0} '%h'\n", which);
  return text + few_decades_text(which, axis);
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

/// A text without braces and backslashes, as HTML wants it.
std::string spoken(std::string text) {
  std::erase_if(text, [](char c) { return std::string_view("{}\\").find(c) != std::string_view::npos; });
  return html_escaped(text);
}

/// "Isotherms: P* against rho*", for readers of screens.
std::string described(Plot const& plot) {
  std::vector<std::string> what;
  for (auto const& panel : plot.panels)
    if (!panel.y.label.empty())
      what.push_back(panel.y.label);
  return spoken(fmt::format("{}: {} against {}", plot.title.empty() ? plot.name : plot.title,
                            fmt::join(what, "; "), plot.x.label));
}

/// gnuplot's picture with a description in the place of the name.
std::string with_description(std::string svg, Plot const& plot) {
  auto const name = fmt::format("<title>{}</title>", plot.name);
  if (auto const at = svg.find(name); at != std::string::npos)
    svg.replace(at, name.size(), fmt::format("<title>{}</title>", described(plot)));
  return svg.insert(svg.find("<svg") + 4, " role=\"img\"");
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
  return with_description(result.output.substr(start), plot);
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
