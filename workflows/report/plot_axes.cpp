#include "workflows/report/plot_axes.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace mesobridge::workflows {

namespace {

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

} // namespace

std::string escaped(std::string const& text) {
  std::string result;
  for (char const c : text)
    result += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return "'" + result + "'";
}

Axis common_x_axis(Plot const& plot) {
  Range range;
  for (auto const& panel : plot.panels)
    for (auto const& series : panel.series)
      for (double const x : series.x)
        range.add(x);
  return with_room(plot.x, range, 0.03);
}

std::string marks_of_low_panel(Panel const& panel, double height) {
  constexpr double high_enough = 180, room_of_a_number = 26; // [px]
  auto const range = y_range(panel);
  if (height >= high_enough || panel.y.logarithmic || !(range.least < range.most))
    return "";
  return fmt::format("set ytics {:.15g}\n", mark_distance(range, std::max(2.0, height / room_of_a_number)));
}

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

std::string axis_text(char which, Axis const& axis) {
  std::string text = fmt::format("set {}label {}{}\nset {}range {}\n", which, escaped(axis.label),
                                 which == 'x' ? " offset 0,0.4" : " offset 0.8,0", which, range_text(axis));
  text += axis.logarithmic ? fmt::format("set logscale {0}\nset format {0} '10^{{%T}}'\n", which)
                           : fmt::format("unset logscale {0}\nset format {0} '%h'\n", which);
  return text + few_decades_text(which, axis);
}

} // namespace mesobridge::workflows
