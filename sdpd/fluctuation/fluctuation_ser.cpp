#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"
#include "sdpd/fluctuation/pair_lanes.hpp"
#include "sdpd/fluctuation/scaled_velocity.hpp"
#include "sdpd/fluctuation/ser_change.hpp"
#include "sdpd/fluctuation/sweep.hpp"

namespace mesobridge::sdpd {
namespace {

/// The bath of eight pairs at the start, and their relative velocities, scaled where masses differ.
struct Start {
  Bath<FloatLanes> bath;
  VectorLanes<Lanes> v;
};
template <class Law, class Scale>
[[gnu::always_inline]] inline Start start_of(Law const& law, Scale const& scale,
                                             FluctuatingParticle const* particles, LocalPair const* pair) {
  ParticleLanes const a(load_lines([&](std::size_t l) { return &particles[pair[l].i]; }));
  ParticleLanes const b(load_lines([&](std::size_t l) { return &particles[pair[l].j]; }));
  return {law.template bath<FloatLanes>({to_float(a.caloric.T_0), to_float(b.caloric.T_0),
                                         to_float(a.caloric.inverse_C_0), to_float(b.caloric.inverse_C_0)}),
          {scale.velocity(a.p_x, b.p_x), scale.velocity(a.p_y, b.p_y), scale.velocity(a.p_z, b.p_z)}};
}
template <class Law, class Scale>
[[gnu::always_inline]] inline Start start_of(Law const& law, Scale const& scale, Row const* momenta,
                                             LocalPair const* pair) {
  RowLanes const a = load_rows([&](std::size_t l) { return &momenta[pair[l].i]; });
  RowLanes const b = load_rows([&](std::size_t l) { return &momenta[pair[l].j]; });
  return {law.template bath<FloatLanes>(),
          {scale.velocity(a[0], b[0]), scale.velocity(a[1], b[1]), scale.velocity(a[2], b[2])}};
}

/// The change of eight pairs in single precision, as numbers that sums of momenta take.
template <class Law>
[[gnu::always_inline]] inline VectorLanes<Lanes>
change_of(Start const& start, InputLanes<Law::across, FloatLanes> const& input, Sweep<Law> const& sweep) {
  VectorLanes<FloatLanes> const v{to_float(start.v.x), to_float(start.v.y), to_float(start.v.z)};
  auto const change = ser_change(sweep.law, start.bath, input, v, sweep.dt);
  return {to_double(change.x), to_double(change.y), to_double(change.z)};
}

/// Calls f(pair, count, scale, v, change) for the pairs of a block, eight at a time.
template <class Law, class Masses, class F>
void for_each_impulse(System const& system, BlockOf<Law>& block, std::size_t number, PairInputs& inputs,
                      Sweep<Law> const& sweep, F const& f) {
  auto const pairs = system.neighbours.pairs(number);
  prepare_pairs(system, sweep.law, block, pairs, sweep.noise.pairs, inputs);
  auto const* const particles = block.particles().data();
  for_each_group(pairs, block.size(), [&](LocalPair const* pair, std::size_t first, std::size_t count) {
    auto const scale = scale_of(block.template masses<Masses>(), pair);
    Start const start = start_of(sweep.law, scale, particles, pair);
    f(pair, count, scale, start.v,
      change_of(start, InputLanes<Law::across, FloatLanes>(inputs, first), sweep));
  });
}

/// The block's part of the impulses of its particles.
template <class Law, class Masses>
void add_impulses(System& system, std::size_t number, Sweep<Law> const& sweep) {
  thread_local BlockOf<Law> block;
  thread_local PairInputs inputs;
  thread_local std::vector<Row> sums;
  block.copy_in(system, number);
  sums.assign(block.size() + 2, Row{});
  for_each_impulse<Law, Masses>(
      system, block, number, inputs, sweep,
      [&](LocalPair const* pair, std::size_t count, auto const& scale, VectorLanes<Lanes> const&,
          VectorLanes<Lanes> const& change) {
        auto const rows =
            to_rows({scale.momentum(change.x), scale.momentum(change.y), scale.momentum(change.z), Lanes{}});
        for (std::size_t l = 0; l < count; ++l) {
          sums[pair[l].i] += rows[l];
          sums[pair[l].j] -= rows[l];
        }
      });
  for_each_member(block.members(), [&](std::size_t local, Index i, Vec3 const&) {
    Row const& sum = sums[local];
    system.impulse[i] += Vec3{sum[0], sum[1], sum[2]};
  });
}

/// The block's part of the heat of its particles.
template <class Law, class Masses>
void add_heat(System& system, std::size_t number, Sweep<Law> const& sweep) {
  thread_local FluctuatingBlock block;
  thread_local PairInputs inputs;
  thread_local std::vector<Vec3> total;
  thread_local std::vector<double> heat;
  block.copy_in(system, number);
  auto const& masses = block.masses<Masses>();
  total.assign(block.size() + 2, {}), heat.assign(block.size(), 0);
  for_each_member(block.members(),
                  [&](std::size_t local, Index i, Vec3 const&) { total[local] = system.impulse[i]; });
  for_each_impulse<Law, Masses>(
      system, block, number, inputs, sweep,
      [&](LocalPair const* pair, std::size_t count, auto const&, VectorLanes<Lanes> const& v,
          VectorLanes<Lanes> const& change) {
        for (std::size_t l = 0; l < count; ++l) {
          Vec3 const of_others = scale_of(masses, pair[l]).velocity(total[pair[l].i], total[pair[l].j]);
          double const given = ser_heat(Vec3{change.x[l], change.y[l], change.z[l]},
                                        Vec3{v.x[l], v.y[l], v.z[l]} + 0.5 * of_others);
          heat[pair[l].i] += given, heat[pair[l].j] += given;
        }
      });
  for_each_member(block.members(),
                  [&](std::size_t local, Index i, Vec3 const&) { system.energy_gain[i] += heat[local]; });
}

/// Gives the impulses to particles without energies.
void apply_impulses(System& system) {
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i)
      system.particles.p[i] += system.impulse[i];
  });
}

/// Gives impulses and heat to the particles.
void apply(System& system) {
  auto& particles = system.particles;
  Failure failure;
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      particles.p[i] += system.impulse[i];
      gain_of_ser(particles, i, system.energy_gain[i], failure);
    }
  });
  system.stop_at(failure);
}

template <class Law>
void fluctuate_ser(System& system, Law const& law, double dt, bool second) {
  system.impulse.assign(system.size(), {});
  Sweep<Law> const sweep{law, dt, SweepNoise::of_fluctuation(system, second)};
  auto const& grid = system.neighbours.grid();
  if constexpr (Law::has_energies)
    system.energy_gain.assign(system.size(), 0);
  with_masses(system, [&]<class Masses>(Masses const&) {
    for_each_block(grid, system.threads,
                   [&](std::size_t block) { add_impulses<Law, Masses>(system, block, sweep); });
    if constexpr (Law::has_energies)
      for_each_block(grid, system.threads,
                     [&](std::size_t block) { add_heat<Law, Masses>(system, block, sweep); });
  });
  if constexpr (Law::has_energies) {
    apply(system);
  } else
    apply_impulses(system);
}

} // namespace

void fluctuate_ser(System& system, double dt, bool second) {
  std::visit([&](auto const& law) { fluctuate_ser(system, law, dt, second); }, system.law);
}

PairIntegrator ser_integrator() {
  return {.name = "ser",
          .summary = "all pairs at once, for short time steps",
          .sweep = fluctuate_ser,
          .short_steps_only = true};
}

} // namespace mesobridge::sdpd
