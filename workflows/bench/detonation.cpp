#include "workflows/bench/detonation.hpp"
#include "md/error.hpp"
#include "md/processor_clock.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd/thermodynamics/reacting.hpp"
#include "workflows/bench/paired_times.hpp"
#include "workflows/bench/settle.hpp"
#include "workflows/built_in.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace mesobridge::workflows {
namespace {

constexpr std::string_view scene_of_detonation = "detonation-nitromethane.toml";
constexpr double D = 6767;              ///< of Chapman and Jouguet [m/s]
constexpr double steps_to_a_zone = 200; ///< 4 ps; it is 2.8 ps long

struct TimedDetonation {
  sdpd::SimulationSettings settings;
  std::uint64_t steps_before; ///< until its front is in the middle of the box
};

/// The scene in another box.
TimedDetonation detonation_in_box(DetonationTiming const& timing) {
  auto const scenes = built_in_scenes();
  auto const file = std::ranges::find(scenes, scene_of_detonation, &BuiltIn::name);
  auto scene = parse_scene(std::string(file->content), scene_of_detonation);
  auto const units = settings_of(scene, timing.threads).units();
  double const l = units.length(), across = timing.across * l, along = timing.along * l;
  double const way = 0.5 * along - scene.regions.at(0).to.at(0).of(along);
  require(way > 0, "--along", timing.along, "must be at least 40 for a detonation, whose beginning is in it");
  scene.box.size = {across, across, along};
  auto const settings = settings_of(scene, timing.threads);
  double const steps = way / (D * settings.dt * units.time());
  return {settings, static_cast<std::uint64_t>(std::max(steps, steps_to_a_zone))};
}

double share_of_mixtures(sdpd::Simulation const& simulation) {
  auto const progress = simulation.snapshot().progress;
  auto const mixed = std::ranges::count_if(
      progress, [](double of) { return of >= sdpd::pure_below && of <= sdpd::pure_above; });
  return static_cast<double>(mixed) / static_cast<double>(simulation.size());
}

/// A fluid that goes on from repeat to repeat.
struct TimedFluid {
  std::string name;
  sdpd::Simulation simulation;
  PairedTimes times = {};
  std::vector<double> mixtures = {};

  /// Microseconds per particle and step.
  double time(int steps) {
    double const before = share_of_mixtures(simulation);
    md::ProcessorClock const clock;
    simulation.advance(static_cast<std::uint64_t>(steps));
    double const seconds = clock.seconds();
    mixtures.push_back(0.5 * (before + share_of_mixtures(simulation)));
    return seconds * 1e6 / (static_cast<double>(simulation.size()) * steps);
  }
};

TimedFluid settled_fluid(std::string name, sdpd::SimulationSettings const& settings) {
  TimedFluid fluid{std::move(name), sdpd::Simulation(settings)};
  settle(fluid.simulation);
  return fluid;
}

/// Whose particles have so many neighbours, within a wider support, for which the box has to be wide enough.
sdpd::SimulationSettings with_neighbours(sdpd::SimulationSettings fluid, double neighbours) {
  fluid.as<sdpd::Sdpd>().h_factor = std::cbrt(neighbours / (4 * std::numbers::pi / 3));
  auto const least = static_cast<std::uint32_t>(std::ceil(2 * (fluid.range() + skin_of(fluid))));
  for (auto& along : fluid.lattice)
    along = std::max(along, least);
  return fluid;
}

std::vector<double> ratios(std::vector<double> const& of, std::vector<double> const& to) {
  std::vector<double> found(of.size());
  std::ranges::transform(of, to, found.begin(), std::divides());
  return found;
}

} // namespace

Json time_detonation(sdpd::SimulationSettings const& ideal_gas, sdpd::SimulationSettings const& all_mixtures,
                     DetonationTiming const& timing) {
  auto const in_box = detonation_in_box(timing);
  TimedFluid detonation{"detonation", sdpd::Simulation(in_box.settings)};
  detonation.simulation.advance(in_box.steps_before);
  auto const wide = with_neighbours(ideal_gas, detonation.simulation.neighbours());
  std::vector<TimedFluid> fluids;
  fluids.push_back(settled_fluid("ideal gas", ideal_gas));
  fluids.push_back(settled_fluid("ideal gas, wide", wide));
  fluids.push_back(settled_fluid("all half burnt", all_mixtures));
  fluids.push_back(std::move(detonation));
  for (int repeat = 0; repeat < timing.repeats; ++repeat)
    for (auto& fluid : fluids)
      fluid.times.cost.push_back(fluid.time(timing.steps));
  Json rows = Json::array();
  for (auto& fluid : fluids) {
    fluid.times.ratio = ratios(fluid.times.cost, fluids[0].times.cost);
    auto const to_wide = ratios(fluid.times.cost, fluids[1].times.cost);
    Json row{{"fluid", fluid.name}, {"n", fluid.simulation.size()}};
    put_times(row, fluid.times);
    row["ratio_to_wide"] = mean_of_repeats(to_wide);
    row["ratio_to_wide_se"] = standard_error_of_repeats(to_wide);
    row["neighbours"] = fluid.simulation.neighbours();
    row["mixtures"] = mean_of_repeats(fluid.mixtures);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string detonation_times_text(Json const& rows) {
  auto text = fmt::format("{} {:>22} {:>10}\n", times_head("fluid", "times the ideal gas"),
                          "times the wide one", "mixtures");
  for (auto const& row : rows)
    text += fmt::format("{} {:>12.3f} +- {:.3f} {:>10.4f}\n", times_line(row, "fluid"),
                        row["ratio_to_wide"].get<double>(), row["ratio_to_wide_se"].get<double>(),
                        row["mixtures"].get<double>());
  return text;
}

} // namespace mesobridge::workflows
