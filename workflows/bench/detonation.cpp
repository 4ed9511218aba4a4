#include "workflows/bench/detonation.hpp"
#include "md/error.hpp"
#include "md/processor_clock.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd/thermodynamics/reacting.hpp"
#include "workflows/bench/paired_times.hpp"
#include "workflows/built_in.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>

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
  sdpd::equilibrate(fluid.simulation, 64, [] { return true; });
  return fluid;
}

} // namespace

Json time_detonation(sdpd::SimulationSettings const& ideal_gas, sdpd::SimulationSettings const& all_mixtures,
                     DetonationTiming const& timing) {
  std::vector<TimedFluid> fluids;
  fluids.push_back(settled_fluid("ideal gas", ideal_gas));
  fluids.push_back(settled_fluid("all half burnt", all_mixtures));
  auto const detonation = detonation_in_box(timing);
  fluids.push_back({"detonation", sdpd::Simulation(detonation.settings)});
  fluids.back().simulation.advance(detonation.steps_before);
  for (int repeat = 0; repeat < timing.repeats; ++repeat)
    for (auto& fluid : fluids) {
      fluid.times.cost.push_back(fluid.time(timing.steps));
      fluid.times.ratio.push_back(fluid.times.cost.back() / fluids[0].times.cost.back());
    }
  Json rows = Json::array();
  for (auto const& fluid : fluids) {
    Json row{{"fluid", fluid.name}, {"n", fluid.simulation.size()}};
    put_times(row, fluid.times);
    row["neighbours"] = fluid.simulation.neighbours();
    row["mixtures"] = mean_of_repeats(fluid.mixtures);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string detonation_times_text(Json const& rows) {
  auto text = fmt::format("{} {:>10}\n", times_head("fluid", "times the ideal gas"), "mixtures");
  for (auto const& row : rows)
    text += fmt::format("{} {:>10.4f}\n", times_line(row, "fluid"), row["mixtures"].get<double>());
  return text;
}

} // namespace mesobridge::workflows
