#include "workflows/report/film_strip.hpp"
#include "md/error.hpp"
#include "workflows/process.hpp"
#include "workflows/report/colour_scale.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/report/plot_axes.hpp"
#include "workflows/report/report.hpp"
#include "workflows/report/svg_parts.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace mesobridge::workflows {
namespace {

constexpr int left = 64, right_margin = 104, top = 34, bottom = 46, gap = 26, shades = 32;
constexpr double narrowest = 40, tallest = 420; ///< heights of a frame, in pixels

void check(FilmStrip const& strip) {
  bool fits = !strip.frames.empty();
  for (auto const& frame : strip.frames)
    fits = fits && frame.x.size() == frame.y.size() && frame.x.size() == frame.value.size();
  if (!fits)
    throw std::logic_error(fmt::format("film '{}': lengths differ, or there is no frame", strip.name));
}

double share_of(FilmStrip const& strip, double value) {
  double const width = strip.value_to - strip.value_from;
  return width > 0 ? (value - strip.value_from) / width : 0.5;
}

/// Where the frames are: as many columns as leave them a fair size.
struct FrameGrid {
  int columns, rows;
  double width, height; ///< of a frame

  explicit FrameGrid(FilmStrip const& strip) {
    double const aspect = (strip.x_to - strip.x_from) / (strip.y_to - strip.y_from),
                 room = plot_width * 1.5 - left - right_margin;
    int const frames = static_cast<int>(strip.frames.size());
    columns = std::min(frames, aspect > 3 ? 1 : aspect > 1.3 ? 2 : 3);
    rows = (frames + columns - 1) / columns;
    width = (room - (columns - 1) * gap) / columns;
    height = std::clamp(width / aspect, narrowest, tallest);
  }
  double x(int frame) const { return left + frame % columns * (width + gap); }
  double y(int frame) const { return top + gap + (frame / columns) * (height + gap); }
  double bottom_edge() const { return top + rows * (height + gap); }
};

/// The points of one shade are one path of dots.
std::string points(FilmStrip const& strip, FilmStrip::Frame const& frame, FrameGrid const& at, int number) {
  double const scale_x = at.width / (strip.x_to - strip.x_from),
               scale_y = at.height / (strip.y_to - strip.y_from);
  std::array<std::string, shades> dots;
  for (std::size_t k = 0; k < frame.x.size(); ++k) {
    double const x = frame.x[k], y = frame.y[k];
    if (!(x >= strip.x_from && x <= strip.x_to && y >= strip.y_from && y <= strip.y_to) ||
        !std::isfinite(frame.value[k]))
      continue;
    auto const shade = static_cast<std::size_t>(
        std::clamp(share_of(strip, frame.value[k]) * shades, 0.0, double{shades} - 1));
    dots[shade] += fmt::format("M{:.1f} {:.1f}h0", at.x(number) + (x - strip.x_from) * scale_x,
                               at.y(number) + at.height - (y - strip.y_from) * scale_y);
  }
  double const size = std::clamp(strip.point_size * std::min(scale_x, scale_y), 1.2, 14.0);
  std::string svg = fmt::format("<g fill='none' stroke-linecap='round' stroke-width='{:.1f}'>\n", size);
  for (std::size_t shade = 0; shade < shades; ++shade)
    if (!dots[shade].empty())
      svg += fmt::format("<path stroke='{}' d='{}'/>\n", scale_colour((double(shade) + 0.5) / shades),
                         dots[shade]);
  return svg + "</g>\n";
}

std::string colour_bar(FilmStrip const& strip, double x, double y, double height) {
  constexpr double width = 14;
  std::string svg = svg_colour_bar(x, y, width, height, shades, scale_colour);
  svg += svg_text(x + width + 4, y + height, "start", number_text(strip.value_from, 3));
  svg += svg_text(x + width + 4, y + 11, "start", number_text(strip.value_to, 3));
  double const label = x + width + 58;
  return svg + svg_text(label, y + height / 2, "middle", strip.value_label,
                        fmt::format("transform='rotate(-90 {:.1f} {:.1f})'", label, y + height / 2));
}

} // namespace

std::string with_raised_numbers(std::string label) {
  for (auto const& [from, to] : {std::pair("^3", "³"), {"^{-21}", "⁻²¹"}, {"^2", "²"}})
    if (auto const at = label.find(from); at != std::string::npos)
      label.replace(at, std::string_view(from).size(), to);
  std::erase_if(label, [](char c) { return c == '\\' || c == '{' || c == '}'; });
  return label;
}

std::string draw_svg(FilmStrip const& strip) {
  check(strip);
  FrameGrid const at(strip);
  double const full_width = plot_width * 1.5, full_height = at.bottom_edge() + bottom;
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {:.0f} {:.0f}' role='img' "
      "font-family='{}' font-size='13' fill='currentColor'>\n<title>{}: {} over {} and {}</title>\n",
      full_width, full_height, plot_font, html_escaped(strip.title), html_escaped(strip.value_label),
      html_escaped(strip.x_label), html_escaped(strip.y_label));
  svg += svg_text(left + (full_width - left - right_margin) / 2, 20, "middle", strip.title);
  int const frames = static_cast<int>(strip.frames.size());
  for (int k = 0; k < frames; ++k) {
    auto const& frame = strip.frames[static_cast<std::size_t>(k)];
    svg += points(strip, frame, at, k);
    svg += fmt::format("<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='none' "
                       "stroke='#8c959f'/>\n",
                       at.x(k), at.y(k), at.width, at.height);
    svg += svg_text(at.x(k), at.y(k) - 6, "start", frame.title);
  }
  for (int column = 0; column < at.columns; ++column) {
    double const x = at.x(column), y = at.bottom_edge() + 16;
    svg += svg_text(x, y, "start", number_text(strip.x_from, 3));
    svg += svg_text(x + at.width, y, "end", number_text(strip.x_to, 3));
    svg += svg_text(x + at.width / 2, y, "middle", strip.x_label);
  }
  svg += svg_text(left - 6, at.y(0) + at.height, "end", number_text(strip.y_from, 3));
  svg += svg_text(left - 6, at.y(0) + 11, "end", number_text(strip.y_to, 3));
  svg += svg_text(16, at.y(0) + at.height / 2, "middle", strip.y_label,
                  fmt::format("transform='rotate(-90 16 {:.1f})'", at.y(0) + at.height / 2));
  double const all = at.bottom_edge() - at.y(0);
  svg += colour_bar(strip, full_width - right_margin + 16, at.y(0), std::min(all, 260.0));
  return svg + "</svg>\n";
}

void draw_png(FilmStrip const& strip, std::size_t frame_number, std::string const& file) {
  check(strip);
  auto const& frame = strip.frames.at(frame_number);
  double const aspect = (strip.x_to - strip.x_from) / (strip.y_to - strip.y_from);
  constexpr int width = 1200;
  int const height = static_cast<int>(std::clamp(200 + 900 / aspect, 280.0, 1200.0));
  double const point = std::clamp(strip.point_size / (strip.x_to - strip.x_from) * 900 / 8, 0.2, 3.0);
  std::string script = fmt::format(
      "set encoding utf8\nset terminal pngcairo size {},{} enhanced font '{},16'\nset output {}\n{}"
      "unset key\nset title {}\nset xlabel {}\nset ylabel {}\nset cblabel {}\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\n"
      "set cbrange [{}:{}]\n$points << EOD\n",
      width, height, plot_font, escaped(file), gnuplot_palette(), escaped(strip.title + ", " + frame.title),
      escaped(strip.x_label), escaped(strip.y_label), escaped(strip.value_label), strip.x_from, strip.x_to,
      strip.y_from, strip.y_to, strip.value_from,
      strip.value_to > strip.value_from ? strip.value_to : strip.value_from + 1);
  for (std::size_t k = 0; k < frame.x.size(); ++k)
    script += fmt::format("{:.6g} {:.6g} {:.6g}\n", frame.x[k], frame.y[k], frame.value[k]);
  script += frame.x.empty()
                ? "EOD\nplot NaN\n"
                : fmt::format("EOD\nplot $points using 1:2:3 with points pt 7 ps {:.2f} palette\n", point);
  if (auto const result = run_process({"gnuplot", "-d"}, script); result.status != 0)
    throw EnvironmentError(fmt::format("gnuplot could not draw '{}': {}", file, result.errors));
}

} // namespace mesobridge::workflows
