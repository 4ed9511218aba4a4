#include "workflows/report/colour_map.hpp"
#include "md/error.hpp"
#include "workflows/report/colour_scale.hpp"
#include "workflows/report/gnuplot.hpp"
#include "workflows/report/plot_axes.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {
namespace {

void check(ColourMap const& map) {
  bool const fits =
      map.x.size() > 1 && map.y.size() > 1 && map.values.size() == map.y.size() &&
      std::ranges::all_of(map.values, [&](auto const& row) { return row.size() == map.x.size(); });
  if (!fits)
    throw std::logic_error(fmt::format("map '{}': sizes do not belong together", map.name));
  for (auto const& row : map.values)
    if (std::ranges::any_of(row, [](double value) { return std::isfinite(value); }))
      return;
  throw PhysicsError(fmt::format("map '{}': there is no finite number to draw", map.name));
}

std::string script(ColourMap const& map) {
  double const dx = map.x[1] - map.x[0], dy = map.y[1] - map.y[0];
  std::string text = fmt::format(
      "set encoding utf8\nset terminal svg size {},{} dynamic enhanced font '{},{}' background "
      "rgb 'white' name '{}'\nset palette {}\nunset key\nset border lw 1 lc rgb '#444444'\n"
      "set tics nomirror out scale 0.6 textcolor rgb '#222222'\nset title {}\nset xlabel {}\nset ylabel {}\n"
      "set cblabel {}\nset lmargin at screen 0.16\nset rmargin at screen 0.8\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\n$map << EOD\n",
      plot_width, plot_height, plot_font, plot_font_size, map.name, gnuplot_scale(), escaped(map.title),
      escaped(map.x_label), escaped(map.y_label), escaped(map.colour_label), map.x.front() - dx / 2,
      map.x.back() + dx / 2, map.y.front() - dy / 2, map.y.back() + dy / 2);
  for (auto const& row : map.values) {
    for (double const value : row)
      text += std::isfinite(value) ? fmt::format("{:.6g} ", value) : "NaN ";
    text += "\n";
  }
  return text + fmt::format("EOD\nplot $map matrix using ({} + $1 * {}):({} + $2 * {}):3 with image\n",
                            map.x.front(), dx, map.y.front(), dy);
}

} // namespace

std::string draw_svg(ColourMap const& map) {
  check(map);
  return gnuplot_svg(
      script(map), map.name,
      fmt::format("{}: {} over {} and {}", map.title, map.colour_label, map.x_label, map.y_label));
}

} // namespace mesobridge::workflows
