#include "sdpd/fluctuation/fluctuation_isothermal.hpp"
#include "sdpd/fluctuation/pair_lanes.hpp"
#include "sdpd/fluctuation/scaled_velocity.hpp"
#include "sdpd/fluctuation/sweep.hpp"
#include "sdpd/state/pair_counts.hpp"

namespace mesobridge::sdpd {
namespace {

/// The steps of up to eight pairs that share no particle.
template <class Law, class Masses>
[[gnu::always_inline]] inline void
fluctuate_group(Row* momenta, Masses const& masses, LocalPair const* pair, PairInputs const& inputs,
                std::size_t first, std::size_t count, Bath<FloatLanes> const& bath, Sweep<Law> const& sweep) {
  RowLanes const a = load_rows([&](std::size_t l) { return &momenta[pair[l].i]; });
  RowLanes const b = load_rows([&](std::size_t l) { return &momenta[pair[l].j]; });
  InputLanes<Law::across, FloatLanes> const input(inputs, first);
  auto const scale = scale_of(masses, pair);
  auto v_of = [&](std::size_t k) [[gnu::always_inline]] { return to_float(scale.velocity(a[k], b[k])); };
  VectorLanes<FloatLanes> const v{v_of(0), v_of(1), v_of(2)};
  auto const change = velocity_change(step_in(bath, sweep.law, input.weight, sweep.dt), input, v);
  auto half = [&](FloatLanes const& of)
                  [[gnu::always_inline]] { return scale.momentum(0.5 * to_double(of)); };
  Lanes const x = half(change.x), y = half(change.y), z = half(change.z);
  auto const rows_a = to_rows({a[0] + x, a[1] + y, a[2] + z, Lanes{}});
  auto const rows_b = to_rows({b[0] - x, b[1] - y, b[2] - z, Lanes{}});
  for (std::size_t l = 0; l < count; ++l) {
    momenta[pair[l].i] = rows_a[l];
    momenta[pair[l].j] = rows_b[l];
  }
}

template <class Law, class Masses>
void sweep_block(System& system, std::size_t number, Sweep<Law> const& sweep, PairCounts& counts) {
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
                       fluctuate_group(block.particles().data(), masses, pair, inputs, at - begin + k, count,
                                       bath, sweep);
                     });
      at = next;
    }
  });
  counts.proposed += pairs.size();
  block.copy_out(system);
}

} // namespace

template <class Law>
void fluctuate_isothermal(System& system, Law const& law, double dt, bool second) {
  Sweep<Law> const sweep{law, dt, SweepNoise::of_fluctuation(system, second)};
  with_masses(system, [&]<class Masses>(Masses const&) {
    sweep_all_blocks<Law>(system, system.pair_counts, [&](std::size_t block, PairCounts& counts, Failure&) {
      sweep_block<Law, Masses>(system, block, sweep, counts);
    });
  });
}

template void fluctuate_isothermal(System&, DpdLaw<Across::none> const&, double, bool);
template void fluctuate_isothermal(System&, DpdLaw<Across::own> const&, double, bool);

} // namespace mesobridge::sdpd
