#include "workflows/sdpd/shock.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/profile_rows.hpp"
#include "workflows/sdpd/run_plots.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {
namespace {

/// The frames of a run; none where something is missing.
std::vector<sdpd::ShockFrame> frames_of(Store const& store, Scene const& scene,
                                        sdpd::SimulationSettings const& settings, std::size_t slices) {
  OutputUnits const units(settings.units(), scene.units);
  auto const axis = static_cast<std::size_t>(moving_axis(scene));
  auto const time = store.read_doubles("profile/time" + units.time_key);
  auto const velocity = profile_rows(store, "velocity" + units.velocity_key, slices, 3, axis);
  auto const rho = profile_rows(store, "rho" + units.density_key, slices),
             P = profile_rows(store, "P" + units.pressure_key, slices),
             T = profile_rows(store, "T_int" + units.temperature_key, slices);
  auto const& motion = settings.faces[axis][0].motion;
  std::vector<sdpd::ShockFrame> frames;
  for (std::size_t k = 0; k < time.size(); ++k)
    frames.push_back({time[k], motion.way_at(time[k]), velocity[k], rho[k], P[k], T[k]});
  return frames;
}

/// The same frames with the mass per volume of the slices in place of the particles' densities, and the
/// temperatures of the particles' motion in place of the internal ones.
std::vector<sdpd::ShockFrame> by_motion(std::vector<sdpd::ShockFrame> frames, Store const& store,
                                        Scene const& scene, sdpd::SimulationSettings const& settings) {
  OutputUnits const units(settings.units(), scene.units);
  std::size_t const slices = frames.front().rho.size();
  auto const number = store.read_integers("profile/number");
  auto T = profile_rows(store, "T_kin" + units.temperature_key, slices);
  double const everywhere = // particles in a slice at the fluid's density
      sdpd::box_of(settings).volume() / std::pow(settings.spacing(), 3) / static_cast<double>(slices);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    for (std::size_t s = 0; s < slices; ++s)
      frames[k].rho[s] = scene.fluid.rho * static_cast<double>(number[k * slices + s]) / everywhere;
    frames[k].T = std::move(T[k]);
  }
  return frames;
}

/// Means over the frames at equal distances from the front, with the spread of the frames as their error.
void average_in_frame(ShockOfRun& shock, ShockData const& data) {
  auto const& [position, v_P, spacing] = data.scale;
  double const width = position[1] - position[0];
  std::array<std::vector<cg::Estimate>*, 5> const means{&shock.rho, &shock.P, &shock.T, &shock.velocity,
                                                        &shock.T_motion};
  for (double depth = -60 * spacing; depth <= 20 * spacing; depth += width) {
    std::array<std::vector<double>, means.size()> seen;
    for (std::size_t k = 0; k < shock.measured.times.size(); ++k) {
      auto const taken = shock.measured.frames[k];
      auto const &frame = data.frames[taken], &motion = data.by_motion[taken];
      double const at = shock.measured.fronts[k] + depth;
      if (at < frame.piston + 15 * spacing)
        continue;
      double const place = (at - position[0]) / width;
      if (place < 0 || place >= static_cast<double>(position.size() - 1))
        continue;
      auto const s = static_cast<std::size_t>(place);
      double const part = place - static_cast<double>(s);
      std::size_t q = 0;
      for (auto const* values : {&frame.rho, &frame.P, &frame.T, &frame.velocity, &motion.T})
        seen[q++].push_back((1 - part) * (*values)[s] + part * (*values)[s + 1]);
    }
    if (seen[0].size() < 16)
      continue;
    shock.depth.push_back(depth);
    for (std::size_t q = 0; q < means.size(); ++q)
      means[q]->push_back(cg::estimate_mean(seen[q]));
  }
}

} // namespace

std::optional<ShockOfRun> shock_in(ShockData const& data) {
  auto const steady = sdpd::steady_shock(data.frames, data.scale),
             motion = sdpd::steady_shock(data.by_motion, data.scale);
  if (!steady || !motion)
    return std::nullopt;
  ShockOfRun shock{.measured = *steady,
                   .mass_per_volume = motion->rho,
                   .T_kin = motion->T,
                   .exact = std::nullopt,
                   .depth = {},
                   .rho = {},
                   .P = {},
                   .T = {},
                   .velocity = {},
                   .T_motion = {}};
  average_in_frame(shock, data);
  return shock;
}

std::optional<ShockData> shock_data_of(Store const& store, Scene const& scene,
                                       sdpd::SimulationSettings const& settings) {
  OutputUnits const units(settings.units(), scene.units);
  bool const along = scene.profile.axis[0] - 'x' == moving_axis(scene);
  double const v_P =
      settings.faces[static_cast<std::size_t>(moving_axis(scene))][0].motion.driving_velocity();
  if (!(v_P > 0) || !along || scene.profile.every == 0)
    return std::nullopt;
  for (auto const& name :
       {"velocity" + units.velocity_key, "rho" + units.density_key, "P" + units.pressure_key,
        "T_int" + units.temperature_key, "T_kin" + units.temperature_key})
    if (!store.contains("profile/" + name))
      return std::nullopt;
  double const spacing = settings.spacing() * units.length;
  ShockData data{.scale = {store.read_doubles("profile/position" + units.length_key), v_P, spacing},
                 .frames = {},
                 .by_motion = {}};
  data.frames = frames_of(store, scene, settings, data.scale.position.size());
  if (data.frames.empty())
    return std::nullopt;
  data.by_motion = by_motion(data.frames, store, scene, settings);
  return data;
}

std::optional<ShockOfRun> shock_of(Store const& store, Scene const& scene,
                                   sdpd::SimulationSettings const& settings) {
  auto const data = shock_data_of(store, scene, settings);
  auto shock = data ? shock_in(*data) : std::nullopt;
  if (shock)
    shock->exact = shock_before_piston(settings);
  return shock;
}

void put_shock(Json& json, ShockOfRun const& shock, OutputUnits const& units) {
  auto const& [v_S, rho, P, T, frames, times, fronts, v_S_gibbs] = shock.measured;
  put(json, "shock_v_S" + units.velocity_key, v_S);
  put(json, "shock_v_S_gibbs" + units.velocity_key, v_S_gibbs);
  put(json, "plateau_rho" + units.density_key, rho);
  put(json, "plateau_mass_per_volume" + units.density_key, shock.mass_per_volume);
  put(json, "plateau_P" + units.pressure_key, P);
  put(json, "plateau_T" + units.temperature_key, T);
  put(json, "plateau_T_kin" + units.temperature_key, shock.T_kin);
  if (shock.exact)
    json["rankine_hugoniot"] = {{"v_S" + units.velocity_key, shock.exact->v_S},
                                {"rho" + units.density_key, shock.exact->behind.rho},
                                {"P" + units.pressure_key, shock.exact->behind.P},
                                {"T" + units.temperature_key, shock.exact->behind.T}};
}

namespace {

Plot in_the_frame(std::string const& quantity, std::string const& key, ShockOfRun const& shock,
                  std::vector<cg::Estimate> const& values, OutputUnits const& units,
                  std::optional<std::pair<double, double>> const& levels) {
  auto const x = axis_of("z" + units.length_key), y = axis_of(quantity + key);
  Plot plot{.name = drawing_name("shock" + quantity),
            .title = quantity + " in the frame of the front",
            .x = {.label = "distance from the front" + x.label.substr(1)},
            .panels = {Panel{}}};
  Series series{.label = "", .x = scaled(shock.depth, x.factor)};
  for (auto const& value : values)
    series.y.push_back(value.mean * y.factor), series.y_error.push_back(value.se * y.factor);
  plot.panels[0].series = {std::move(series)};
  plot.panels[0].y.label = y.label;
  if (levels)
    plot.panels[0].level_lines = {levels->first * y.factor, levels->second * y.factor};
  return plot;
}

Plot way_of_the_front(ShockOfRun const& shock, OutputUnits const& units) {
  auto const x = axis_of("time" + units.time_key), y = axis_of("front" + units.length_key);
  auto plot = one_panel("shockfront", "The way of the front", x.label, y.label);
  plot.panels[0].series = {{.label = "",
                            .x = scaled(shock.measured.times, x.factor),
                            .y = scaled(shock.measured.fronts, y.factor),
                            .y_error = {}}};
  return plot;
}

} // namespace

Section shock_section(ShockOfRun const& shock, OutputUnits const& units) {
  bool const si = !units.length_key.empty();
  Table table{
      .header = shock.exact ? comparison_header() : std::vector<std::string>{"Quantity", "Ours"},
      .caption = fmt::format(
          "The front and the state behind it, from blocks of frames{}. The front that all else refers to is "
          "where the velocity last falls through v_P/2, coming from ahead (sdpd/README.md, Eq. (S43)); "
          "Gibbs's surface, from the densities before the piston (Eq. (S58)), is beside it.",
          shock.exact ? ", beside the relations of Rankine and Hugoniot with the same equation of state"
                      : "")};
  auto const add = [&](std::string const& name, std::string const& unit, cg::Estimate const& ours,
                       auto exact) {
    auto const quantity = si ? name + " [" + unit + "]" : name;
    table.rows.push_back(shock.exact ? comparison_row(quantity, ours, exact(*shock.exact))
                                     : std::vector<std::string>{quantity, with_error_text(ours)});
  };
  add("velocity of the shock", "m/s", shock.measured.v_S, [](auto const& of) { return of.v_S; });
  add("the same by Gibbs's surface", "m/s", shock.measured.v_S_gibbs, [](auto const& of) { return of.v_S; });
  add("density behind it", "kg/m^3", shock.measured.rho, [](auto const& of) { return of.behind.rho; });
  add("mass per volume behind it", "kg/m^3", shock.mass_per_volume,
      [](auto const& of) { return of.behind.rho; });
  add("pressure", "Pa", shock.measured.P, [](auto const& of) { return of.behind.P; });
  add("temperature", "K", shock.measured.T, [](auto const& of) { return of.behind.T; });
  add("temperature of the particles' motion", "K", shock.T_kin, [](auto const& of) { return of.behind.T; });
  using Levels = std::optional<std::pair<double, double>>;
  auto const levels = [&](auto member) {
    return shock.exact ? Levels(std::pair(shock.exact->ahead.*member, shock.exact->behind.*member))
                       : Levels();
  };
  Figure figure{
      {},
      fmt::format("Means over the frames with their standard errors{}. The first 15 mean distances between "
                  "particles at the piston are left out.",
                  shock.exact ? "; lines: the states ahead and behind by Rankine and Hugoniot" : "")};
  figure.svgs.push_back(draw_svg(way_of_the_front(shock, units)));
  figure.svgs.push_back(draw_svg(
      in_the_frame("rho", units.density_key, shock, shock.rho, units, levels(&fitting::EosState::rho))));
  figure.svgs.push_back(
      draw_svg(in_the_frame("P", units.pressure_key, shock, shock.P, units, levels(&fitting::EosState::P))));
  figure.svgs.push_back(draw_svg(
      in_the_frame("T", units.temperature_key, shock, shock.T, units, levels(&fitting::EosState::T))));
  return {"Shock", {std::move(table), std::move(figure)}};
}

} // namespace mesobridge::workflows
