#include "fitting/znd.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos/detonation_options.hpp"
#include "workflows/eos/kinetics_options.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct EosZndOptions {
  ReactionOptions explosive;
  KineticsOptions kinetics;
  std::optional<double> D;
  double last = 0.999;
};

Columns zone_columns(std::vector<fitting::ZonePoint> const& points) {
  Columns columns{{"lambda", "", "", {}},
                  {"x", "_m", "m", {}},
                  {"t", "_s", "s", {}},
                  {"P", "_Pa", "Pa", {}},
                  {"rho", "_kg_m3", "kg/m^3", {}},
                  {"T", "_K", "K", {}},
                  {"u", "_m_s", "m/s", {}},
                  {"e", "_J_kg", "J/kg", {}},
                  {"s", "_J_kg_K", "J/(kg K)", {}},
                  {"c_v", "_J_kg_K", "J/(kg K)", {}},
                  {"sound_speed", "_m_s", "m/s", {}}};
  for (auto const& point : points) {
    auto const& state = point.state;
    double const row[] = {point.lambda,
                          point.x,
                          point.t,
                          state.P,
                          point.rho,
                          state.T,
                          point.u,
                          state.e,
                          state.s,
                          state.c_v,
                          std::sqrt(state.sound_speed_squared)};
    for (std::size_t i = 0; i < columns.size(); ++i)
      columns[i].values.push_back(row[i]);
  }
  return columns;
}

/// Pressure, temperature and progress over the distance behind the front, to twice that of the zone's end.
Plot zone_plot(std::string const& title, std::vector<fitting::ZonePoint> const& points) {
  constexpr double nm = 1e-9, GPa = 1e9;
  Series P{.style = SeriesStyle::lines}, T = P, lambda = P;
  double const last =
      2 * std::ranges::find_if(points, [](auto const& p) { return p.lambda >= fitting::zone_end; })->x;
  for (auto const& point : points) {
    if (point.x > last)
      break;
    for (auto* const series : {&P, &T, &lambda})
      series->x.push_back(point.x / nm);
    P.y.push_back(point.state.P / GPa);
    T.y.push_back(point.state.T);
    lambda.y.push_back(point.lambda);
  }
  return {.name = "zone",
          .title = plain(title),
          .x = {.label = "distance behind the front [nm]"},
          .panels = {Panel{.series = {P}, .y = {.label = "P [GPa]"}, .legend = Legend::none},
                     Panel{.series = {T}, .y = {.label = "T [K]"}, .legend = Legend::none},
                     Panel{.series = {lambda}, .y = {.label = "lambda"}, .legend = Legend::none}}};
}

Result znd(EosZndOptions const& options, Context const& context) {
  if (context.options.output)
    curve_file(*context.options.output);
  auto const fluid = options.explosive.fluid(context);
  auto const kinetics = options.kinetics.kinetics(fluid.at_rest.rho);
  auto const crussard = fluid.crussard();
  auto const cj = crussard.chapman_jouguet();
  if (options.D)
    require_positive_number("--D", *options.D);
  auto const progress = fitting::progress_to_draw(options.last);
  fitting::ReactionZone const zone(fluid, options.D.value_or(cj.v_S));
  auto const points = fitting::reaction_profile(zone, kinetics, progress);
  auto const& spike = zone.von_neumann().behind;
  auto const [length, duration] = fitting::zone_extent(points);
  Columns const head{{"D", "_m_s", "m/s", {zone.D()}},
                     {"D_CJ", "_m_s", "m/s", {cj.v_S}},
                     {"von_neumann_P", "_Pa", "Pa", {spike.P}},
                     {"von_neumann_rho", "_kg_m3", "kg/m^3", {spike.rho}},
                     {"von_neumann_T", "_K", "K", {spike.T}},
                     {"von_neumann_u", "_m_s", "m/s", {zone.von_neumann().v_P}},
                     {"zone", "_m", "m", {length}},
                     {"zone_time", "_s", "s", {duration}}};
  auto const columns = zone_columns(points);
  Result result;
  result.json = options.explosive.detonation.names();
  tell_first_row(result, head, false);
  result.json["q_J_kg"] = fluid.q;
  result.json["P0_Pa"] = fluid.at_rest.P;
  result.json["order"] = options.kinetics.order;
  result.json["neighbour_sum_at_rest"] = kinetics.neighbour_sum(fluid.at_rest.rho);
  result.json["zone_begin_lambda"] = fitting::zone_begin;
  result.json["zone_end_lambda"] = fitting::zone_end;
  put_first_row(result.json["chapman_jouguet"], shock_columns({cj}), false);
  put_first_row(result.json["end"], shock_columns({zone.D() > cj.v_S ? crussard.from_speed(zone.D()) : cj}),
                false);
  result.text +=
      fmt::format("The zone reaches from lambda = {} to {}; the state at rest has P = {:.6g} Pa.\n",
                  fitting::zone_begin, fitting::zone_end, fluid.at_rest.P);
  auto const title =
      fmt::format("Reaction zone of {}: D = {:.5g} m/s", options.explosive.detonation.reactant, zone.D());
  put_curve(context, result, columns, false, [&] { return zone_plot(title, points); });
  return result;
}

void declare(CLI::App& app, EosZndOptions& options) {
  options.explosive.declare(app);
  options.kinetics.declare(app);
  app.add_option(
      "--D", options.D,
      "Velocity of the front in m/s. If not given that of Chapman and Jouguet; more: an overdriven "
      "detonation");
  app.add_option("--end", options.last, "Progress at which the profile ends, between 0.98 and 1")
      ->capture_default_str();
  app.description(
      "The reaction zone of a steady plane detonation (Zel'dovich, von Neumann, Doering): a shock in the "
      "unreacted explosive, and behind it the reaction along the Rayleigh line. The profile (x: distance "
      "behind the front) has a point a row; zone_m is the distance from lambda = 0.02 to 0.98. No viscosity "
      "and no conduction. A detonation whose flow would turn sonic before the end of the reaction (a "
      "pathological one, faster than that of Chapman and Jouguet) is refused.");
}

} // namespace

extern Declaration const eos_znd_command = with_options<EosZndOptions, declare, znd>;

} // namespace mesobridge::workflows
