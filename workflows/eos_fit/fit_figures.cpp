#include "workflows/eos_fit/fit_figures.hpp"
#include "fitting/jump_conditions.hpp"
#include "md/error.hpp"
#include "workflows/report/number_text.hpp"
#include <algorithm>
#include <map>
#include <set>

namespace mesobridge::workflows {
namespace {

using fitting::DataPath;
using fitting::Datum;
using fitting::EosFit;
using fitting::FittedObservation;
using fitting::Observation;
using fitting::Quantity;

/// How a quantity is drawn.
struct Drawn {
  std::string label;
  double unit; ///< SI units in one unit of the axis
};

Drawn const& drawn(Quantity quantity) {
  static std::map<Quantity, Drawn> const all{
      {Quantity::rho, {"rho [kg/m³]", 1}},    {Quantity::T, {"T [K]", 1}},
      {Quantity::e, {"e [MJ/kg]", 1e6}},      {Quantity::P, {"P [GPa]", 1e9}},
      {Quantity::c_v, {"c_v [J/(kg K)]", 1}}, {Quantity::sound_speed, {"sound speed [km/s]", 1e3}},
      {Quantity::v_P, {"v_P [km/s]", 1e3}},   {Quantity::v_S, {"v_S [km/s]", 1e3}}};
  return all.at(quantity);
}

std::optional<double> given(Observation const& observation, Quantity quantity) {
  for (auto const& datum : observation.given)
    if (datum.quantity == quantity)
      return datum.value;
  return std::nullopt;
}

/// Shocks are drawn over the piston's velocity, other states over density.
Quantity abscissa(DataPath path) {
  return path == DataPath::hugoniot ? Quantity::v_P : Quantity::rho;
}

double position(FittedObservation const& fitted) {
  return fitted.observation.path == DataPath::hugoniot ? fitted.state.v_P : fitted.state.rho;
}

/// Observations that lie on one curve: of one isotherm (or start), by a name for the legend.
using Curves = std::map<std::pair<double, double>, std::vector<FittedObservation const*>>;

std::pair<double, double> curve_of(Observation const& observation) {
  if (observation.path == DataPath::state)
    return {given(observation, Quantity::T).value_or(-1), 0};
  return {observation.start->rho, observation.start->T.value_or(observation.start->P.value_or(0))};
}

std::string legend(Observation const& observation) {
  if (observation.path == DataPath::state) {
    auto const T = given(observation, Quantity::T);
    return T ? fmt::format("{} K", number_text(*T)) : "given e";
  }
  return fmt::format("from {} kg/m³", number_text(observation.start->rho));
}

Curves curves_of(EosFit const& fit, DataPath path, Quantity quantity) {
  Curves curves;
  for (auto const& fitted : fit.observations)
    if (fitted.observation.path == path &&
        std::ranges::count(fitted.data, quantity, &fitting::FittedDatum::quantity))
      curves[curve_of(fitted.observation)].push_back(&fitted);
  return curves;
}

/// The fit along one curve with its band, over the extent of its data.
std::vector<Series> fitted_curve(EosFit const& fit, std::vector<FittedObservation const*> const& members,
                                 Quantity quantity, int colour) {
  auto const& first = members.front()->observation;
  auto const x_of = abscissa(first.path);
  auto const [low, high] = std::ranges::minmax(members, {}, [](auto const* f) { return position(*f); });
  double const x_min = position(*low), x_max = position(*high);
  Series line{.x = {}, .y = {}, .y_error = {}, .style = SeriesStyle::lines, .colour = colour};
  Series band{.x = {}, .y = {}, .y_error = {}, .style = SeriesStyle::band, .colour = colour};
  bool const by_energy = first.path == DataPath::state && !given(first, Quantity::T);
  if (by_energy || !(x_max > x_min)) // no curve joins these states
    return {};
  constexpr int points = 60;
  for (int k = 0; k <= points; ++k) {
    double const x = x_min + (x_max - x_min) * k / points;
    Observation at{.path = first.path, .start = first.start, .given = {{x_of, x}}};
    if (first.path == DataPath::state)
      at.given.push_back({Quantity::T, *given(first, Quantity::T)});
    auto const y = fit.estimate(at, quantity);
    auto const unit = drawn(quantity).unit;
    line.x.push_back(x / drawn(x_of).unit), line.y.push_back(y.mean / unit);
    band.x.push_back(x / drawn(x_of).unit), band.y.push_back(y.mean / unit);
    band.y_error.push_back(2 * y.se / unit);
  }
  return {band, line};
}

/// A single state makes no plot: the table says it.
bool several_positions(Curves const& curves) {
  std::set<double> positions;
  for (auto const& [key, members] : curves)
    for (auto const* const fitted : members)
      positions.insert(position(*fitted));
  return positions.size() > 1;
}

Plot plot_of(EosFit const& fit, DataPath path, Quantity quantity, Curves const& curves) {
  constexpr std::string_view names[] = {"states", "Hugoniot", "isentrope", "Chapman-Jouguet state"};
  constexpr std::size_t most_in_legend = 8;
  auto const [label, unit] = drawn(quantity);
  auto const x = drawn(abscissa(path));
  Plot plot{
      .name = fmt::format("fit{}{}", static_cast<int>(path), static_cast<int>(quantity)),
      .title = fmt::format("{}: {}", names[static_cast<std::size_t>(path)], symbol(quantity)),
      .x = {.label = x.label},
      .panels = {Panel{.y = {.label = label}, .height = 2}, Panel{.y = {.label = "(data - fit) / se"}}}};
  auto& values = plot.panels[0];
  auto& deviations = plot.panels[1];
  values.legend = curves.size() > most_in_legend ? Legend::none : Legend::below;
  deviations.legend = Legend::none;
  deviations.level_lines = {-2, 0, 2};
  int colour = 0;
  for (auto const& [key, members] : curves) {
    for (auto const& series : fitted_curve(fit, members, quantity, colour))
      values.series.push_back(series);
    Series data{
        .label = legend(members.front()->observation), .x = {}, .y = {}, .y_error = {}, .colour = colour};
    Series deviation{.x = {}, .y = {}, .y_error = {}, .colour = colour};
    for (auto const* const fitted : members)
      for (auto const& datum : fitted->data)
        if (datum.quantity == quantity) {
          double const at = position(*fitted) / x.unit;
          data.x.push_back(at), data.y.push_back(datum.value / unit), data.y_error.push_back(datum.se / unit);
          deviation.x.push_back(at), deviation.y.push_back(datum.deviation());
        }
    values.series.push_back(data);
    deviations.series.push_back(deviation);
    ++colour;
  }
  return plot;
}

/// What a datum of the row says of the shock, with the standard errors of one quantity carried along.
cg::Estimate by_jump(Observation const& shock, Quantity quantity) {
  double const P_0 = shock.start->P.value_or(shock.at_rest ? shock.at_rest->P : 0), step = 1e-3;
  auto const& given = shock.given.front();
  auto measured = std::ranges::find_if(shock.measured, [](auto const& datum) {
    return datum.quantity == Quantity::v_S || datum.quantity == Quantity::v_P ||
           datum.quantity == Quantity::P || datum.quantity == Quantity::rho;
  });
  auto const value = [&](double errors) {
    Datum shifted = *measured;
    shifted.value += errors * measured->se;
    return fitting::jump_of(shock.start->rho, P_0, given, shifted).of(quantity);
  };
  return {value(0), std::abs(value(step) - value(0)) / step, 0};
}

bool says_jump(FittedObservation const& fitted) {
  auto const& observation = fitted.observation;
  return observation.path == DataPath::hugoniot &&
         std::ranges::any_of(observation.measured, [](Datum const& datum) {
           return datum.quantity == Quantity::v_S || datum.quantity == Quantity::v_P ||
                  datum.quantity == Quantity::P || datum.quantity == Quantity::rho;
         });
}

/// Hugoniot curves as pressure over density, from the state at rest on, with the data as mass and momentum
/// say them.
std::optional<Plot> pressure_over_density(EosFit const& fit) {
  Curves curves;
  for (auto const& fitted : fit.observations)
    if (says_jump(fitted))
      curves[curve_of(fitted.observation)].push_back(&fitted);
  if (curves.empty())
    return std::nullopt;
  auto const [P_label, P_unit] = drawn(Quantity::P);
  Plot plot{.name = "pressure",
            .title = "Hugoniot: P over density",
            .x = {.label = drawn(Quantity::rho).label},
            .panels = {Panel{.y = {.label = P_label}}}};
  int colour = 0;
  for (auto const& [key, members] : curves) {
    Series data{
        .label = legend(members.front()->observation), .x = {}, .y = {}, .y_error = {}, .colour = colour};
    Series line{.x = {}, .y = {}, .y_error = {}, .style = SeriesStyle::lines, .colour = colour};
    auto const* const strongest =
        *std::ranges::max_element(members, {}, [](auto const* fitted) { return fitted->state.v_P; });
    if (auto const& start = *members.front()->observation.start; start.T) {
      Observation const rest{.given = {{Quantity::rho, start.rho}, {Quantity::T, *start.T}}};
      line.x.push_back(start.rho), line.y.push_back(fit.value(rest, Quantity::P) / P_unit);
    }
    constexpr int points = 60;
    for (int k = 1; k <= points; ++k) {
      Observation const at{.path = DataPath::hugoniot,
                           .start = members.front()->observation.start,
                           .given = {{Quantity::v_P, strongest->state.v_P * k / points}}};
      line.x.push_back(fit.value(at, Quantity::rho)), line.y.push_back(fit.value(at, Quantity::P) / P_unit);
    }
    for (auto const* const fitted : members) {
      auto const P = by_jump(fitted->observation, Quantity::P);
      data.x.push_back(by_jump(fitted->observation, Quantity::rho).mean);
      data.y.push_back(P.mean / P_unit), data.y_error.push_back(P.se / P_unit);
    }
    plot.panels[0].series.push_back(line), plot.panels[0].series.push_back(data);
    ++colour;
  }
  return plot;
}

} // namespace

std::vector<Plot> eos_fit_figures(EosFit const& fit) {
  std::set<std::pair<DataPath, Quantity>> kinds;
  for (auto const& fitted : fit.observations)
    for (auto const& datum : fitted.data)
      kinds.emplace(fitted.observation.path, datum.quantity);
  std::vector<Plot> plots;
  for (auto const& [path, quantity] : kinds)
    if (auto const curves = curves_of(fit, path, quantity); path != DataPath::cj && several_positions(curves))
      plots.push_back(plot_of(fit, path, quantity, curves));
  if (auto plot = pressure_over_density(fit))
    plots.push_back(std::move(*plot));
  return plots;
}

} // namespace mesobridge::workflows
