#include "fitting/eos/evaluate.hpp"
#include "workflows/lj_to_sdpd/figures.hpp"
#include <algorithm>
#include <set>

namespace mesobridge::workflows {
namespace {

/// U* (total, per atom) or P* of a model in Lennard-Jones units.
double value(fitting::AnyEos const& eos, double rho, double T, GridQuantity quantity) {
  return std::visit(
      [&](auto const& model) {
        auto const isochore = model.isochore(rho);
        return quantity == GridQuantity::U ? isochore.energy(T) : isochore.pressure(T);
      },
      eos);
}

double T_max(fitting::AnyEos const& eos) {
  return std::visit([](auto const& model) { return model.domain().T_max; }, eos);
}

/// The coldest, the middle and the hottest isotherm.
std::vector<double> shown_temperatures(fitting::LjBwrFit const& fit) {
  std::set<double> all;
  for (auto const& point : fit.points)
    all.insert(point.T);
  std::vector<double> const sorted(all.begin(), all.end());
  return {sorted.front(), sorted[sorted.size() / 2], sorted.back()};
}

/// One isotherm: everything as a difference to Kolafa-Nezbeda, in per cent.
class Differences {
 public:
  Differences(fitting::LjBwrFit const& fit, double T, GridQuantity quantity)
      : fit_(fit), T_(T), quantity_(quantity), base_(fitting::material("lj-kn").eos) {}

  Series curve(fitting::AnyEos const& eos, std::string label, SeriesStyle style, int colour) const {
    Series series{
        .label = std::move(label), .x = {}, .y = {}, .y_error = {}, .style = style, .colour = colour};
    auto const& region = fit_.sampled;
    for (int k = 0; k <= 60; ++k) {
      double const rho = region.rho_min + (region.rho_max - region.rho_min) * k / 60;
      series.x.push_back(rho);
      series.y.push_back(scale(rho) * (value(eos, rho, T_, quantity_) - value(base_, rho, T_, quantity_)));
    }
    return series;
  }

  Series md(std::string label, int colour) const {
    Series series{.label = std::move(label), .colour = colour};
    for (auto const& point : fit_.points)
      if (point.T == T_) {
        bool const energy = quantity_ == GridQuantity::U;
        double const factor = scale(point.rho), base = value(base_, point.rho, T_, quantity_);
        series.x.push_back(point.rho);
        series.y.push_back(factor * ((energy ? point.U : point.P) - base));
        series.y_error.push_back(factor * (energy ? point.U_se : point.P_se));
      }
    return series;
  }

 private:
  /// In per cent of the value, or of T* where U* is smaller: it passes through zero.
  double scale(double rho) const { return 100 / std::max(std::abs(value(base_, rho, T_, quantity_)), T_); }

  fitting::LjBwrFit const& fit_;
  double T_;
  GridQuantity quantity_;
  fitting::AnyEos const& base_;
};

} // namespace

Plot models_and_md(ChainResults const& results, GridQuantity quantity) {
  bool const energy = quantity == GridQuantity::U;
  Plot plot{.name = energy ? "modelsU" : "modelsP",
            .title = fmt::format("{} against Kolafa-Nezbeda: MD, fit and two published equations",
                                 energy ? "Energy" : "Pressure"),
            .x = {.label = "rho*"},
            .panels = {}};
  for (double const T : shown_temperatures(results.fit)) {
    Differences const differences(results.fit, T, quantity);
    bool const first = plot.panels.empty();
    auto label = [first](char const* text) { return first ? std::string(text) : std::string(); };
    Panel panel{.y = {.label = fmt::format("[%] at T* = {:.3g}", T)}, .level_lines = {0}};
    panel.series.push_back(differences.md(label("MD"), 0));
    panel.series.push_back(differences.curve(results.fit.eos, label("fit"), SeriesStyle::lines, 0));
    panel.series.push_back(
        differences.curve(fitting::material("lj").eos, label("BWR 1993"), SeriesStyle::dashes, 1));
    auto const& thol = fitting::material("lj-thol").eos;
    if (T <= T_max(thol))
      panel.series.push_back(differences.curve(thol, label("Thol 2016"), SeriesStyle::lines, 2));
    plot.panels.push_back(std::move(panel));
  }
  return plot;
}

} // namespace mesobridge::workflows
