#pragma once
#include "sdpd/fluctuation/pair_lanes.hpp"
#include "sdpd/fluctuation/scaled_velocity.hpp"
#include "sdpd/fluctuation/sweep.hpp"
#include "sdpd/state/pair_counts.hpp"

/// Pair after pair in the order of the lists at a set temperature, for particles without internal energies
/// (DPD). What a pair does is told by a function object,
///     step(exact, pairs)
/// which makes of the exact Ornstein-Uhlenbeck steps of a PairGroup the steps that are taken.
namespace mesobridge::sdpd {

/// Up to eight pairs of a block that share no particle.
struct PairGroup {
  LocalPair const* pairs;
  std::size_t count;
  std::uint32_t const *ids, *bits; ///< of the block's particles; spare ones of each pair's noise
};

template <class Law, class Masses, class Step>
[[gnu::always_inline]] inline void
step_pairs(Row* momenta, Masses const& masses, PairGroup const& group, PairInputs const& inputs,
           std::size_t first, Bath<FloatLanes> const& bath, Sweep<Law> const& sweep, Step const& step) {
  LocalPair const* const pair = group.pairs;
  RowLanes const a = load_rows([&](std::size_t l) { return &momenta[pair[l].i]; });
  RowLanes const b = load_rows([&](std::size_t l) { return &momenta[pair[l].j]; });
  InputLanes<Law::across, FloatLanes> const input(inputs, first);
  auto const scale = scale_of(masses, pair);
  auto v_of = [&](std::size_t k) [[gnu::always_inline]] { return to_float(scale.velocity(a[k], b[k])); };
  VectorLanes<FloatLanes> const v{v_of(0), v_of(1), v_of(2)};
  auto const exact = step_in(bath, sweep.law, input.weight, sweep.dt);
  auto const change = velocity_change(step(exact, group), input, v);
  auto half = [&](FloatLanes const& of)
                  [[gnu::always_inline]] { return scale.momentum(0.5 * to_double(of)); };
  Lanes const x = half(change.x), y = half(change.y), z = half(change.z);
  auto const rows_a = to_rows({a[0] + x, a[1] + y, a[2] + z, Lanes{}});
  auto const rows_b = to_rows({b[0] - x, b[1] - y, b[2] - z, Lanes{}});
  for (std::size_t l = 0; l < group.count; ++l) {
    momenta[pair[l].i] = rows_a[l];
    momenta[pair[l].j] = rows_b[l];
  }
}

template <class Masses, class Law, class Step>
void sweep_isothermal_block(System& system, std::size_t number, Sweep<Law> const& sweep, Step const& step,
                            PairCounts& counts) {
  thread_local MomentumBlock block;
  thread_local PairInputs inputs;
  auto const& neighbours = system.neighbours;
  auto const pairs = neighbours.pairs(number);
  auto const bath = sweep.law.template bath<FloatLanes>();
  block.copy_in(system, number);
  auto const& masses = block.masses<Masses>();
  for_each_run(neighbours.pair_ends(number), [&](std::uint32_t begin, std::uint32_t end,
                                                 std::span<std::uint32_t const> ends) {
    prepare_pairs(system, sweep.law, block, pairs.subspan(begin, end - begin), sweep.noise.pairs, inputs);
    std::uint32_t at = begin;
    for (std::uint32_t const next : ends) {
      for_each_group(pairs.subspan(at, next - at), block.size(),
                     [&](LocalPair const* pair, std::size_t k, std::size_t count) {
                       std::size_t const first = at - begin + k;
                       step_pairs(block.particles().data(), masses,
                                  {pair, count, block.ids().data(), &inputs.bits[first]}, inputs, first, bath,
                                  sweep, step);
                     });
      at = next;
    }
  });
  counts.proposed += pairs.size();
  block.copy_out(system);
}

template <class Law, class Step>
void sweep_isothermal(System& system, Sweep<Law> const& sweep, Step const& step) {
  with_masses(system, [&]<class Masses>(Masses const&) {
    sweep_all_blocks<Law>(system, system.pair_counts, [&](std::size_t block, PairCounts& counts, Failure&) {
      sweep_isothermal_block<Masses>(system, block, sweep, step, counts);
    });
  });
}

} // namespace mesobridge::sdpd
