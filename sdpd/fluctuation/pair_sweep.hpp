#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/pair_states.hpp"
#include "sdpd/fluctuation/strip.hpp"
#include "sdpd/state/pair_counts.hpp"

/// Pair after pair in the order of the lists: the sweep of fluctuation and dissipation, and that of heat
/// conduction. What pairs exchange is told by a type, with
///     Exchange::Strip<Particles>                 the steps in lanes (FluctuationStrip, HeatStrip)
///     Exchange::exact_step(scheme, two, sweep, counts)   the step of a pair that the lanes leave over
///     Exchange::expands_present_state            whether that takes the present state from expansions
namespace mesobridge::sdpd {

/// A pair that the lanes leave over.
struct LeftPair {
  PairStates states;
  PairInputs const& inputs;
  std::size_t k;    ///< its number among the inputs
  double uniform;   ///< for the Metropolis test
  double boltzmann; ///< of the invariant measure
};

[[gnu::always_inline]] inline ExpandedParticles in_lanes(FluctuatingBlock& block) {
  return {block.particles().data()};
}
[[gnu::always_inline]] inline OwnMassParticles in_lanes(OwnMassBlock& block) {
  return {{block.particles().data()}, &block.masses()};
}
[[gnu::always_inline]] inline ConstantCapacityParticles in_lanes(ConstantCapacityBlock& block) {
  return {block.particles().data(), {block.heat_capacity(), 1 / block.heat_capacity()}};
}

/// One block while it is swept.
template <class Exchange, class Law, PairScheme scheme, class Block>
class BlockSweep {
 public:
  using BlockStrip = typename Exchange::template Strip<decltype(in_lanes(std::declval<Block&>()))>;

  BlockSweep(System& system, Block& block, PairInputs& inputs, BlockStrip& strip, Sweep<Law> const& sweep,
             PairCounts& counts, Failure& failure)
      : system_(system), heated_(expands ? system.thermodynamics->heated_states() : nullptr), block_(block),
        inputs_(inputs), strip_(strip), sweep_(sweep), counts_(counts), failure_(failure) {}

  /// Sweeps one matching, whose inputs begin at `first`. False when a particle has left the equation of
  /// state.
  bool matching(std::span<LocalPair const> pairs, std::size_t first) {
    for (std::size_t k = 0; k < pairs.size(); k += strip_length)
      if (!strip(pairs.subspan(k, std::min(strip_length, pairs.size() - k)), first + k))
        return false;
    return true;
  }

 private:
  /// Whether exact steps take what a particle has from its expansion. SSA asks for nothing else, so exactly.
  static constexpr bool expands = Exchange::expands_present_state && scheme != PairScheme::ssa;

  bool strip(std::span<LocalPair const> pairs, std::size_t first) {
    auto const particles = in_lanes(block_);
    strip_.read(particles, pairs, block_.size());
    strip_.template propose<scheme>(inputs_, first, sweep_);
    strip_.template judge<scheme>();
    if constexpr (scheme == PairScheme::ems)
      strip_.test(inputs_, first, sweep_);
    strip_.write(particles);
    counts_.proposed += pairs.size();
    return strip_.for_each_open([&](std::size_t k, GroupOutcome const& outcome, unsigned bit) {
      return finish(outcome, bit, pairs[k], first + k);
    });
  }
  /// Whatever the lanes could not do.
  bool finish(GroupOutcome const& outcome, unsigned bit, LocalPair pair, std::size_t k) {
    if (outcome.out_of_domain & bit)
      ++counts_.out_of_domain;
    else if ((outcome.exact | outcome.test) & bit) {
      if (!exact_step(pair, k))
        return false;
    } else if (!((outcome.made | outcome.renew) & bit))
      ++counts_.metropolis;
    bool const moved_far = (outcome.exact | outcome.test | outcome.renew) & bit;
    return !moved_far || (renew(pair.i) && renew(pair.j));
  }
  bool renew(std::size_t local) {
    return block_.has_temperature(local) || block_.renew(system_, local, expands, failure_);
  }
  /// False, and a report, when a particle has no state that the step could begin with.
  bool exact_step(LocalPair pair, std::size_t k) {
    double const uniform = sweep_.noise.uniform(block_.ids()[pair.i], block_.ids()[pair.j], inputs_.bits[k]);
    std::array particles{block_.particle(system_, pair.i), block_.particle(system_, pair.j)};
    try {
      auto const states =
          states_of({&particles[0], &particles[1]}, {block_.index(pair.i), block_.index(pair.j)});
      Exchange::exact_step(
          scheme,
          {.states = states, .inputs = inputs_, .k = k, .uniform = uniform, .boltzmann = system_.boltzmann},
          sweep_, counts_);
    } catch (PhysicsError const& error) {
      failure_.report(std::min(block_.ids()[pair.i], block_.ids()[pair.j]), error.what());
      return false;
    }
    block_.set_particle(system_, pair.i, particles[0]);
    block_.set_particle(system_, pair.j, particles[1]);
    return true;
  }

  PairStates states_of(std::array<FluctuatingParticle*, 2> particles, std::array<Index, 2> places) const {
    return heated_ ? PairStates(system_, *heated_, particles, places)
                   : PairStates(system_, particles, places);
  }

  System& system_;
  HeatedStates const* heated_; ///< what the model offers, if it does
  Block& block_;
  PairInputs& inputs_;
  BlockStrip& strip_;
  Sweep<Law> const& sweep_;
  PairCounts& counts_;
  Failure& failure_;
};

template <class Exchange, PairScheme scheme, class Block, class Law>
void sweep_block(System& system, std::size_t number, Sweep<Law> const& sweep, PairCounts& counts,
                 Failure& failure) {
  using ThisSweep = BlockSweep<Exchange, Law, scheme, Block>;
  thread_local Block block;
  thread_local PairInputs inputs;
  thread_local typename ThisSweep::BlockStrip strip;
  auto const& neighbours = system.neighbours;
  auto const pairs = neighbours.pairs(number);
  block.copy_in(system, number);
  ThisSweep sweep_lanes(system, block, inputs, strip, sweep, counts, failure);
  bool fine = true;
  for_each_run(neighbours.pair_ends(number), [&](std::uint32_t begin, std::uint32_t end,
                                                 std::span<std::uint32_t const> ends) {
    if (!fine)
      return;
    prepare_pairs(system, sweep.law, block, pairs.subspan(begin, end - begin), sweep.noise.pairs, inputs);
    std::uint32_t at = begin;
    for (std::uint32_t const next : ends) {
      fine = sweep_lanes.matching(pairs.subspan(at, next - at), at - begin);
      if (!fine)
        return;
      at = next;
    }
  });
  block.copy_out(system);
}

template <class Exchange, PairScheme scheme, class Block, class Law>
void sweep_pairs_of(System& system, Sweep<Law> const& sweep, PairCounts& total) {
  sweep_all_blocks<Law>(system, total, [&](std::size_t block, PairCounts& counts, Failure& failure) {
    sweep_block<Exchange, scheme, Block>(system, block, sweep, counts, failure);
  });
}

template <class Exchange, PairScheme scheme, class Law>
void sweep_pairs(System& system, Sweep<Law> const& sweep, PairCounts& total) {
  if (!system.particles.mass.empty())
    sweep_pairs_of<Exchange, scheme, OwnMassBlock>(system, sweep, total);
  else if (system.thermodynamics->constant_heat_capacity())
    sweep_pairs_of<Exchange, scheme, ConstantCapacityBlock>(system, sweep, total);
  else
    sweep_pairs_of<Exchange, scheme, FluctuatingBlock>(system, sweep, total);
}

/// One sweep by SSA, AMS or EMS, for laws with energies; its pairs are counted in `total`.
template <class Exchange, class Law>
void sweep_pairs(System& system, PairScheme scheme, Sweep<Law> const& sweep, PairCounts& total) {
  switch (scheme) {
  case PairScheme::ssa:
    return sweep_pairs<Exchange, PairScheme::ssa>(system, sweep, total);
  case PairScheme::ams:
    return sweep_pairs<Exchange, PairScheme::ams>(system, sweep, total);
  case PairScheme::ems:
    return sweep_pairs<Exchange, PairScheme::ems>(system, sweep, total);
  }
}

} // namespace mesobridge::sdpd
