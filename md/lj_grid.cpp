#include "md/lj_grid.hpp"
#include "md/seeds.hpp"
#include "md/shared_runs.hpp"
#include <cmath>

namespace mesobridge::md {
namespace {

ThermoSample sample_of(std::span<double const> numbers) {
  return {std::int64_t(numbers[0]), numbers[1], numbers[2], numbers[3]};
}

std::vector<double> costs_of(std::span<LjState const> states) {
  std::vector<double> costs;
  for (LjState const& state : states)
    costs.push_back(state.rho);
  return costs;
}

} // namespace

std::vector<LjState> lj_grid(LjRegion region, int densities, int temperatures) {
  require(region.rho_min > 0 && std::isfinite(region.rho_min), "lowest density", region.rho_min,
          "must be > 0");
  require(region.rho_max > region.rho_min && std::isfinite(region.rho_max), "highest density", region.rho_max,
          "must be above the lowest");
  require(region.T_min > 0 && std::isfinite(region.T_min), "lowest temperature", region.T_min, "must be > 0");
  require(region.T_max > region.T_min && std::isfinite(region.T_max), "highest temperature", region.T_max,
          "must be above the lowest");
  require(densities >= 2 && densities <= 1000, "densities of the grid", densities, "must be 2 ... 1000");
  require(temperatures >= 2 && temperatures <= 1000, "temperatures of the grid", temperatures,
          "must be 2 ... 1000");
  std::vector<LjState> states;
  for (int i = 0; i < temperatures; ++i)
    for (int j = 0; j < densities; ++j)
      states.push_back(
          {std::lerp(region.rho_min, region.rho_max, double(j) / (densities - 1)),
           region.T_min * std::pow(region.T_max / region.T_min, double(i) / (temperatures - 1))});
  return states;
}

std::vector<LjState> default_lj_grid(Preset preset) {
  int const edge = preset == Preset::quick ? 5 : preset == Preset::standard ? 8 : 12;
  return lj_grid(default_lj_region, edge, edge);
}

std::vector<std::vector<std::size_t>> share_states(std::span<LjState const> states, int ranks) {
  return share_by_cost(costs_of(states), ranks);
}

bool sample_lj_grid(MpiWorld const& world, std::span<LjState const> states, LjFluidSettings const& settings,
                    LjGridConsumers const& consumers) {
  require(!states.empty(), "states of the grid", states.size(), "at least one is needed");
  for (LjState state : states)
    check(state, settings);
  auto own = settings;
  own.log_file = log_of_rank(settings.log_file, world.rank());
  Log log = Log::replace;
  auto const make = [&](std::size_t index, RunReporter& reporter) {
    own.seed = mix(settings.seed, index);
    LjFluidConsumers const watching{
        .thermo =
            [&](ThermoSample const& sample) { // a step number is exact in a double up to 2^53
              reporter.sample({double(sample.step), sample.T, sample.U, sample.P});
              return true;
            },
        .frames = {},
        .frame_every = own.sample_every,
        .steps = [&](std::int64_t done) { return reporter.steps(done); }};
    bool const complete = sample_lj_fluid(world, Ranks::own, states[index], own, watching, log) &&
                          reporter.conclude(own.steps(), {});
    log = Log::append;
    return complete;
  };
  SharedRunConsumers shared{.samples = {}, .conclusion = {}, .progress = consumers.progress};
  if (consumers.samples)
    shared.samples = [&](std::size_t index, std::span<double const> numbers) {
      return consumers.samples(index, samples_of<4>(numbers, sample_of));
    };
  double const all_steps = double(settings.steps()) * double(states.size());
  return share_runs(world, share_states(states, world.size()), all_steps, make, shared);
}

} // namespace mesobridge::md
