#include "sdpd/step/fluctuation.hpp"
#include "sdpd/step/exact_pair.hpp"
#include "sdpd/step/fluctuation_entropy.hpp"
#include "sdpd/step/fluctuation_hybrid.hpp"
#include "sdpd/step/fluctuation_implicit.hpp"
#include "sdpd/step/fluctuation_isothermal.hpp"
#include "sdpd/step/fluctuation_strip.hpp"

namespace mesobridge::sdpd {
namespace {

ExpandedParticles in_lanes(FluctuatingBlock& block) {
  return {block.particles().data()};
}
ConstantCapacityParticles in_lanes(ConstantCapacityBlock& block) {
  return {block.particles().data(), {block.heat_capacity(), 1 / block.heat_capacity()}};
}

/// One block while it is swept.
template <class Law, PairScheme scheme, class Block>
class BlockSweep {
 public:
  using BlockStrip = Strip<decltype(in_lanes(std::declval<Block&>()))>;

  BlockSweep(System& system, Block& block, PairInputs& inputs, BlockStrip& strip, Sweep<Law> const& sweep,
             PairCounts& counts, Failure& failure)
      : system_(system), block_(block), inputs_(inputs), strip_(strip), sweep_(sweep), counts_(counts),
        failure_(failure) {}

  /// Sweeps one matching, whose inputs begin at `first`. False when a particle has left the equation of
  /// state.
  bool matching(std::span<LocalPair const> pairs, std::size_t first) {
    for (std::size_t k = 0; k < pairs.size(); k += strip_length)
      if (!strip(pairs.subspan(k, std::min(strip_length, pairs.size() - k)), first + k))
        return false;
    return true;
  }

 private:
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
    else if ((outcome.exact | outcome.test) & bit)
      exact_step(pair, k);
    else if (!((outcome.made | outcome.renew) & bit))
      ++counts_.metropolis;
    bool const moved_far = (outcome.exact | outcome.test | outcome.renew) & bit;
    return !moved_far || (renew(pair.i) && renew(pair.j));
  }
  bool renew(std::size_t local) {
    return block_.has_temperature(local) || block_.renew(system_, local, failure_);
  }
  Vec3 noise(std::size_t k) const {
    if constexpr (Law::noise == PairNoise::along)
      return double{inputs_.G_x[k]} * Vec3{inputs_.e_x[k], inputs_.e_y[k], inputs_.e_z[k]};
    else
      return {inputs_.G_x[k], inputs_.G_y[k], inputs_.G_z[k]};
  }
  void exact_step(LocalPair pair, std::size_t k) {
    auto const a = block_.ids()[pair.i], b = block_.ids()[pair.j];
    double const uniform =
        acceptance_uniform(sweep_.noise.acceptance, std::min(a, b), std::max(a, b), inputs_.bits[k]);
    double const par = inputs_.weight[k];
    double perp = Law::across == Across::none ? 0 : par;
    if constexpr (Law::across == Across::own)
      perp = inputs_.weight_across[k];
    std::array particles{block_.particle(system_, pair.i), block_.particle(system_, pair.j)};
    ExactPair<Law>(system_, {&particles[0], &particles[1]}, {block_.index(pair.i), block_.index(pair.j)})
        .step(scheme, {.e = {inputs_.e_x[k], inputs_.e_y[k], inputs_.e_z[k]}, .weight = {par, perp}},
              {.G = noise(k), .uniform = uniform}, sweep_, counts_);
    block_.set_particle(system_, pair.i, particles[0]);
    block_.set_particle(system_, pair.j, particles[1]);
  }

  System& system_;
  Block& block_;
  PairInputs& inputs_;
  BlockStrip& strip_;
  Sweep<Law> const& sweep_;
  PairCounts& counts_;
  Failure& failure_;
};

template <class Block, class Law, PairScheme scheme>
void sweep_block(System& system, std::size_t number, Sweep<Law> const& sweep, PairCounts& counts,
                 Failure& failure) {
  thread_local Block block;
  thread_local PairInputs inputs;
  auto const& neighbours = system.neighbours;
  auto const pairs = neighbours.pairs(number);
  block.copy_in(system, number);
  thread_local typename BlockSweep<Law, scheme, Block>::BlockStrip strip;
  BlockSweep<Law, scheme, Block> sweep_lanes(system, block, inputs, strip, sweep, counts, failure);
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

template <PairScheme scheme, class Block, class Law>
void fluctuate_blocks(System& system, Law const& law, double dt, bool second) {
  sweep_all_blocks(system, law, dt, second,
                   [&](std::size_t block, Sweep<Law> const& sweep, PairCounts& counts, Failure& failure) {
                     sweep_block<Block, Law, scheme>(system, block, sweep, counts, failure);
                   });
}

template <PairScheme scheme, class Law>
void fluctuate(System& system, Law const& law, double dt, bool second) {
  if (system.thermodynamics->constant_heat_capacity())
    fluctuate_blocks<scheme, ConstantCapacityBlock>(system, law, dt, second);
  else
    fluctuate_blocks<scheme, FluctuatingBlock>(system, law, dt, second);
}

template <class Law>
void fluctuate(System& system, Law const& law, PairScheme scheme, double dt, bool second) {
  if constexpr (!Law::has_energies)
    return fluctuate_isothermal(system, law, dt, second);
  else
    switch (scheme) {
    case PairScheme::ssa:
      return fluctuate<PairScheme::ssa>(system, law, dt, second);
    case PairScheme::ams:
      return fluctuate<PairScheme::ams>(system, law, dt, second);
    case PairScheme::ems:
      return fluctuate<PairScheme::ems>(system, law, dt, second);
    case PairScheme::ser:
    case PairScheme::ser_implicit:
    case PairScheme::hybrid:
    case PairScheme::entropy:
      break; // made below for every law
    }
}

} // namespace

void fluctuate(System& system, PairScheme scheme, double dt, bool second) {
  if (scheme == PairScheme::ser_implicit)
    return fluctuate_implicit(system, dt, second);
  if (scheme == PairScheme::entropy)
    return fluctuate_entropies(system, dt, second);
  if (scheme == PairScheme::hybrid)
    return fluctuate_hybrid(system, dt, second);
  if (scheme == PairScheme::ser)
    return fluctuate_ser(system, dt, second);
  std::visit([&](auto const& law) { fluctuate(system, law, scheme, dt, second); }, system.law);
}

} // namespace mesobridge::sdpd
