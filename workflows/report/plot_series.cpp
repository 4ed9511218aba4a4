#include "workflows/report/plot_series.hpp"
#include "workflows/report/plot_axes.hpp"
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>
#include <string_view>

namespace mesobridge::workflows {

namespace {

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

/// Letters that a reader sees of a text with gnuplot's marks.
std::size_t letters(std::string const& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
    bool const continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80; // of a UTF-8 character
    return !continues && std::string_view("{}^_@&~\\").find(c) == std::string_view::npos;
  }));
}

} // namespace

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

LegendBox legend_of(Plot const& plot) {
  constexpr double sample_and_gaps = 74, letter = 0.6 * plot_font_size;
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

} // namespace mesobridge::workflows
