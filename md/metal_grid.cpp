#include "md/metal_grid.hpp"
#include "md/seeds.hpp"
#include "md/shared_runs.hpp"
#include <array>
#include <bit>

namespace mesobridge::md {
namespace {

MetalSample sample_of(std::span<double const> numbers) {
  return {std::int64_t(numbers[0]), numbers[1], numbers[2], numbers[3], numbers[4]};
}

/// The same seed for the same state in whatever company it is sampled.
std::uint64_t seed_of(std::uint64_t seed, MetalState state) {
  return mix(mix(seed, std::bit_cast<std::uint64_t>(state.rho)), std::bit_cast<std::uint64_t>(state.T));
}

} // namespace

bool sample_metal_grid(MpiWorld const& world, std::span<MetalState const> states,
                       MetalSettings const& settings, MetalGridConsumers const& consumers) {
  require(!states.empty(), "states of the grid", states.size(), "at least one is needed");
  std::vector<double> costs;
  for (MetalState state : states) {
    check(state, settings);
    costs.push_back(state.rho); // the neighbours of an atom
  }
  auto own = settings;
  own.log_file = log_of_rank(settings.log_file, world.rank());
  Log log = Log::replace;
  auto const make = [&](std::size_t index, RunReporter& reporter) {
    own.seed = seed_of(settings.seed, states[index]);
    auto const end = sample_metal(world, states[index], own,
                                  {.samples =
                                       [&](MetalSample const& s) {
                                         reporter.sample({double(s.step), s.T, s.e, s.P, s.displacement_2});
                                         return true;
                                       },
                                   .steps = [&](std::int64_t done) { return reporter.steps(done); }},
                                  log);
    log = Log::append;
    return end && reporter.conclude(own.steps(), std::array{end->lattice_order, end->part_beyond_table});
  };
  SharedRunConsumers shared{.samples = {}, .conclusion = {}, .progress = consumers.progress};
  if (consumers.samples)
    shared.samples = [&](std::size_t k, std::span<double const> n) {
      return consumers.samples(k, samples_of<5>(n, sample_of));
    };
  if (consumers.end)
    shared.conclusion = [&](std::size_t k, std::span<double const> n) {
      return consumers.end(k, {.lattice_order = n[0], .part_beyond_table = n[1]});
    };
  double const all_steps = double(settings.steps()) * double(states.size());
  return share_runs(world, share_by_cost(costs, world.size()), all_steps, make, shared);
}

} // namespace mesobridge::md
