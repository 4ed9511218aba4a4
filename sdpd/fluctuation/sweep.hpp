#pragma once
#include "sdpd/fluctuation/fluctuating_block.hpp"
#include "sdpd/neighbours/for_each_block.hpp"
#include "sdpd/state/pair_counts.hpp"

namespace mesobridge::sdpd {

/// Random numbers of a sweep: of the pairs' steps and of their Metropolis tests.
struct SweepNoise {
  NoiseSource pairs, acceptance;

  SweepNoise(std::uint64_t seed, std::uint64_t step, Stream of_pairs, Stream of_acceptance)
      : pairs(seed, of_pairs, step), acceptance(seed, of_acceptance, step) {}
  SweepNoise(System const& system, Stream of_pairs, Stream of_acceptance)
      : SweepNoise(system.seed, system.step, of_pairs, of_acceptance) {}

  /// The uniform number, in [0, 1), of the Metropolis test of particles `a` and `b` (ids): the spare bits of
  /// their step first, then 32 of its own.
  double uniform(std::uint32_t a, std::uint32_t b, std::uint32_t spare) const {
    auto const word = Philox4x32::generate(
        {std::min(a, b), std::max(a, b), acceptance.step_low, acceptance.step_high_and_stream},
        acceptance.key);
    return (spare + word[0] / 4294967296.0) / (1u << spare_bits);
  }

  /// Of the first or the second sweep of fluctuation and dissipation in a step.
  static SweepNoise of_fluctuation(System const& system, bool second) {
    return {system, fluctuation_noise.of(second), acceptance_noise.of(second)};
  }
  /// Of heat conduction.
  static SweepNoise of_conduction(System const& system, bool second) {
    return {system, conduction_noise.of(second), conduction_acceptance_noise.of(second)};
  }
};

/// What a sweep needs beside the pairs.
template <class Law>
struct Sweep {
  Law const& law;
  double dt;
  SweepNoise noise;
};

/// Calls f(begin, end, ends of the matchings) for runs of whole matchings of some hundred pairs, so that what
/// is prepared for them stays in the cache.
template <class F>
void for_each_run(std::span<std::uint32_t const> ends, F&& f) {
  constexpr std::uint32_t length = 256;
  std::uint32_t begin = 0;
  for (std::size_t m = 0; m < ends.size();) {
    std::size_t const first = m;
    do
      ++m;
    while (m < ends.size() && ends[m] - begin <= length);
    f(begin, ends[m - 1], ends.subspan(first, m - first));
    begin = ends[m - 1];
  }
}

/// Calls sweep_block(block, counts, failure) for every block, adds its counts to `total` and then gives the
/// energies gained, and the temperatures that belong to them, to the particles.
template <class Law, class SweepBlock>
void sweep_all_blocks(System& system, PairCounts& total, SweepBlock const& sweep_block) {
  auto& particles = system.particles;
  auto const& grid = system.neighbours.grid();
  if constexpr (Law::has_energies)
    set_all(system, system.energy_gain, 0.0);
  std::vector<PairCounts> counts(grid.blocks().size());
  // The phases after a failure are not swept: a particle that has left the equation of state would take its
  // neighbours with it, and the message would be about them.
  Failure failure;
  auto const begin = grid.phase_begin();
  std::atomic<std::size_t> failed_phase = begin.size();
  for_each_block(grid, system.threads, [&](std::size_t block) {
    auto const phase =
        static_cast<std::size_t>(std::upper_bound(begin.begin(), begin.end(), block) - begin.begin());
    if (phase > failed_phase)
      return;
    Failure of_block;
    sweep_block(block, counts[block], of_block);
    if (of_block.any()) {
      failure.report(of_block.id(), of_block.message());
      failed_phase = phase;
    }
  });
  system.stop_at(failure);
  for (auto const& of_block : counts)
    total += of_block;
  if constexpr (Law::has_energies) {
    for_each_index(particles.size(), system.threads, [&](std::size_t i) {
      particles.eps[i] += system.energy_gain[i];
      particles.T[i] = particles.caloric[i].T(system.energy_gain[i]);
    });
  }
}

} // namespace mesobridge::sdpd
