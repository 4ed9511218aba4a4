#include "fitting/eos/kolafa_nezbeda.hpp"
#include "workflows/lj_to_sdpd/figures.hpp"
#include <map>

namespace mesobridge::workflows {
namespace {

/// The points of a grid by their set temperature.
std::map<double, std::vector<fitting::LjBwrFitPoint>> by_temperature(fitting::LjBwrFit const& fit) {
  std::map<double, std::vector<fitting::LjBwrFitPoint>> isotherms;
  for (auto const& point : fit.points)
    isotherms[point.T].push_back(point);
  return isotherms;
}

struct Value {
  double data, se, fit, published;
};

Value value(fitting::LjBwrFitPoint const& p, GridQuantity quantity) {
  return quantity == GridQuantity::U ? Value{p.U, p.U_se, p.U_fit, p.U_published}
                                     : Value{p.P, p.P_se, p.P_fit, p.P_published};
}

double kolafa_nezbeda(fitting::LjBwrFitPoint const& p, GridQuantity quantity) {
  return quantity == GridQuantity::U ? 1.5 * p.T + fitting::kolafa_nezbeda_energy(p.rho, p.T)
                                     : fitting::kolafa_nezbeda_pressure(p.rho, p.T);
}

/// U or P along an isotherm by an equation of state in Lennard-Jones units.
Series curve(fitting::LjBwr const& eos, double T, fitting::LjRegion const& region, GridQuantity quantity,
             SeriesStyle style, int colour) {
  Series series{.x = {}, .y = {}, .y_error = {}, .style = style, .colour = colour};
  for (int k = 0; k <= 80; ++k) {
    double const rho = region.rho_min + (region.rho_max - region.rho_min) * k / 80;
    auto const isochore = eos.isochore(rho);
    series.x.push_back(rho);
    series.y.push_back(quantity == GridQuantity::U ? isochore.energy(T) : isochore.pressure(T));
  }
  return series;
}

} // namespace

Plot isotherms(ChainResults const& results, GridQuantity quantity) {
  auto const& fit = results.fit;
  auto const& published = std::get<fitting::LjBwr>(fitting::material("lj").eos);
  std::string const symbol = quantity == GridQuantity::U ? "U" : "P";
  Plot plot{.name = "isotherms" + symbol,
            .title = "Isotherms: MD (points), fit (lines), published (dashes)",
            .x = {.label = "rho*"},
            .panels = {Panel{.height = 2}, Panel{}}};
  auto& values = plot.panels[0];
  auto& differences = plot.panels[1];
  values.y.label = symbol + "*";
  differences.y.label = "difference to fit [%]";
  differences.legend = Legend::none;
  differences.level_lines = {0};
  int colour = 0;
  for (auto const& [T, points] : by_temperature(fit)) {
    Series data{.label = fmt::format("T* = {:.3g}", T), .colour = colour};
    Series residual{.x = {}, .y = {}, .y_error = {}, .colour = colour};
    Series witness{.x = {}, .y = {}, .y_error = {}, .style = SeriesStyle::lines, .colour = colour};
    Series other{.x = {}, .y = {}, .y_error = {}, .style = SeriesStyle::dashes, .colour = colour};
    for (auto const& point : points) {
      auto const v = value(point, quantity);
      double const scale = 100 / std::max(std::abs(v.fit), T); // U* passes through zero
      data.x.push_back(point.rho), data.y.push_back(v.data), data.y_error.push_back(v.se);
      residual.x.push_back(point.rho), residual.y.push_back(scale * (v.data - v.fit));
      residual.y_error.push_back(scale * v.se);
      other.x.push_back(point.rho), other.y.push_back(scale * (v.published - v.fit));
      witness.x.push_back(point.rho), witness.y.push_back(scale * (kolafa_nezbeda(point, quantity) - v.fit));
    }
    values.series.push_back(data);
    values.series.push_back(curve(fit.eos, T, fit.sampled, quantity, SeriesStyle::lines, colour));
    values.series.push_back(curve(published, T, fit.sampled, quantity, SeriesStyle::dashes, colour));
    differences.series.push_back(residual);
    differences.series.push_back(witness);
    differences.series.push_back(other);
    ++colour;
  }
  return plot;
}

Plot held_out(ChainResults const& results) {
  Plot plot{.name = "heldout",
            .title = "Each state predicted by a fit without it",
            .x = {.label = "rho*"},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = "(MD - prediction) / standard error";
  panel.level_lines = {-3, 0, 3};
  Series U{
      .label = "U*",
  },
      P{.label = "P*"};
  for (auto const& point : results.fit.points) {
    U.x.push_back(point.rho - 0.004), U.y.push_back(point.U_held_out_deviation);
    P.x.push_back(point.rho + 0.004), P.y.push_back(point.P_held_out_deviation);
  }
  panel.series = {U, P};
  return plot;
}

} // namespace mesobridge::workflows
