#include "workflows/transport/viscosity_output.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/summary.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t most_waves_drawn = 4, most_points_drawn = 60;

Json wave_json(cg::WaveViscosity const& wave) {
  Json json{{"k", wave.k}, {"vectors", wave.vectors}};
  put(json, "eta", wave.eta);
  put(json, "eta_integral", wave.eta_integral);
  put(json, "kT", wave.temperature);
  json["memory"] = wave.memory;
  json["fitted_lags"] = wave.fitted;
  for (auto const& value : wave.correlation) {
    json["correlation"].push_back(value.mean);
    json["correlation_se"].push_back(value.se);
  }
  return json;
}

/// Points with errors and the fit through them, in one colour.
void add_decay(Panel& panel, cg::WaveViscosity const& wave, double interval, int colour) {
  Series points{.label = fmt::format("k = {}", number_text(wave.k, 4)), .colour = colour};
  Series line{.label = {}, .style = SeriesStyle::lines, .colour = colour};
  std::size_t const step = 1 + wave.correlation.size() / most_points_drawn;
  for (std::size_t lag = 0; lag < wave.correlation.size(); ++lag) {
    double const t = double(lag) * interval;
    if (lag % step == 0)
      points.x.push_back(t), points.y.push_back(wave.correlation[lag].mean),
          points.y_error.push_back(wave.correlation[lag].se);
    if (lag < wave.fitted)
      line.x.push_back(t), line.y.push_back(wave.decay(t));
  }
  panel.series.push_back(std::move(points));
  panel.series.push_back(std::move(line));
}

std::string decays(cg::Viscosity const& found) {
  auto plot = one_panel("transverse", "Correlation of transverse currents", "t", "C(k,t)/C(k,0)", {0});
  for (std::size_t w = 0; w < std::min(found.waves.size(), most_waves_drawn); ++w)
    add_decay(plot.panels[0], found.waves[w], found.interval, int(w));
  return draw_svg(plot);
}

std::string over_wave_vectors(cg::Viscosity const& found) {
  auto plot = one_panel("viscosity", "Viscosity over the wave vector", "k^2", "η(k)");
  plot.x.min = 0;
  Series points{.label = "by the decay of each length of waves"};
  double last = 0;
  for (auto const& wave : found.waves) {
    last = std::max(last, wave.k * wave.k);
    points.x.push_back(wave.k * wave.k), points.y.push_back(wave.eta.mean),
        points.y_error.push_back(wave.eta.se);
  }
  plot.panels[0].series = {
      std::move(points),
      {.label = "their line",
       .x = {0, last},
       .y = {found.eta.mean, found.eta.mean + found.slope * last},
       .y_error = {},
       .style = SeriesStyle::lines},
      {.label = "η at k → 0", .x = {0}, .y = {found.eta.mean}, .y_error = {found.eta.se}}};
  return draw_svg(plot);
}

Table table_of(cg::Viscosity const& found) {
  Table table{.header = {"k", "vectors", "η(k)", "η(k), by the integral", "memory", "k_B T of the currents"},
              .caption = fmt::format("The line η + b k² misses them by χ² = {} with {} degrees of freedom.",
                                     number_text(found.chi2, 3), found.waves.size() - 2)};
  for (auto const& wave : found.waves)
    table.rows.push_back({number_text(wave.k, 4), fmt::format("{}", wave.vectors), with_error_text(wave.eta),
                          with_error_text(wave.eta_integral), number_text(wave.memory, 3),
                          with_error_text(wave.temperature)});
  return table;
}

} // namespace

Json viscosity_json(cg::Viscosity const& found) {
  Json json;
  put(json, "eta", found.eta);
  put(json, "eta_integral", found.eta_integral);
  json["eta_slope"] = found.slope;
  json["eta_chi2"] = found.chi2;
  json["eta_freedom"] = found.waves.size() - 2;
  json["eta_blocks"] = std::size_t(found.eta.n_eff);
  json["density"] = found.density;
  json["waves"] = Json::array();
  for (auto const& wave : found.waves)
    json["waves"].push_back(wave_json(wave));
  json["waves_left_out"] = found.left_out;
  return json;
}

std::string viscosity_text(cg::Viscosity const& found) {
  auto text = fmt::format(
      "eta         {}  (from transverse currents, k = {:.4g} ... {:.4g} continued to 0; by their integrals "
      "{})\n",
      with_error_text(found.eta), found.waves.front().k, found.waves.back().k,
      with_error_text(found.eta_integral));
  for (auto const& reason : found.left_out)
    text += fmt::format("            (left out: {})\n", reason);
  return text;
}

Section viscosity_section(cg::Viscosity const& found) {
  return {"Shear viscosity",
          {Figure{{decays(found), over_wave_vectors(found)},
                  "Left: how waves of momentum across their direction die away, with what a viscoelastic "
                  "fluid makes of them (lines, over the lags that are fitted). Right: the viscosities that "
                  "they tell, continued to infinitely long waves."},
           table_of(found)}};
}

} // namespace mesobridge::workflows
