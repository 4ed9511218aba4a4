#include "sdpd/step/fluctuation_ssa.hpp"
#include "sdpd/step/fluctuation_sweep.hpp"

namespace mesobridge::sdpd {
namespace {

/// A particle's caloric expansion in lanes.
struct CaloricLanes {
  Lanes T_0, inverse_C_0, curvature, limit;

  [[gnu::always_inline]] Lanes T(Lanes const& u) const { return T_0 + u * (inverse_C_0 + curvature * u); }
  [[gnu::always_inline]] Lanes inverse_C(Lanes const& u) const { return inverse_C_0 + 2.0 * curvature * u; }
  [[gnu::always_inline]] unsigned in_reach(Lanes const& u) const {
    Lanes const change = T(u) - T_0;
    return less(change < 0.0 ? -change : change, limit);
  }
};

/// Eight particles, one of each pair.
struct ParticleLanes {
  Lanes p_x, p_y, p_z, u;
  CaloricLanes caloric;

  [[gnu::always_inline]] ParticleLanes(LineLanes const& line)
      : p_x(line[0]), p_y(line[1]), p_z(line[2]), u(line[3]), caloric{line[4], line[5], line[6], line[7]} {}
};

struct VectorLanes {
  Lanes x, y, z;
};

/// The change of the relative velocity v of eight pairs.
[[gnu::always_inline]] inline VectorLanes velocity_change(ParticleLanes const& a, ParticleLanes const& b,
                                                          VectorLanes const& v, PairInputs const& inputs,
                                                          std::size_t first, Sweep const& sweep) {
  auto input = [first](std::vector<float> const& values) { return load<FloatLanes>(&values[first]); };
  PairBath<FloatLanes> const bath(sweep.boltzmann, to_float(a.caloric.T(a.u)), to_float(b.caloric.T(b.u)),
                                  to_float(a.caloric.inverse_C(a.u)), to_float(b.caloric.inverse_C(b.u)));
  FloatLanes const chi = input(inputs.chi);
  auto const [par, perp] = bath.step(sweep.friction.par(chi), sweep.friction.perp(chi),
                                     sweep.friction.par_is_twice_perp(), sweep.dt);
  FloatLanes const e_x = input(inputs.e_x), e_y = input(inputs.e_y), e_z = input(inputs.e_z);
  FloatLanes const G_x = input(inputs.G_x), G_y = input(inputs.G_y), G_z = input(inputs.G_z);
  FloatLanes const v_x = to_float(v.x), v_y = to_float(v.y), v_z = to_float(v.z);
  FloatLanes const along = (par.decay - perp.decay) * (e_x * v_x + e_y * v_y + e_z * v_z) +
                           (par.kick - perp.kick) * (e_x * G_x + e_y * G_y + e_z * G_z);
  return {to_double(perp.decay * v_x + perp.kick * G_x + along * e_x),
          to_double(perp.decay * v_y + perp.kick * G_y + along * e_y),
          to_double(perp.decay * v_z + perp.kick * G_z + along * e_z)};
}

/// The Ornstein-Uhlenbeck steps of up to eight pairs that share no particle. Returns the lanes in which both
/// particles are still within reach of their caloric expansions.
[[gnu::always_inline]] inline unsigned fluctuate_group(FluctuatingParticle* particles, LocalPair const* pair,
                                                       PairInputs const& inputs, std::size_t first,
                                                       std::size_t count, Sweep const& sweep) {
  ParticleLanes const a(load_lines([&](std::size_t l) { return &particles[pair[l].i]; }));
  ParticleLanes const b(load_lines([&](std::size_t l) { return &particles[pair[l].j]; }));
  VectorLanes const v{a.p_x - b.p_x, a.p_y - b.p_y, a.p_z - b.p_z};
  VectorLanes const dv = velocity_change(a, b, v, inputs, first, sweep);
  Lanes const heat =
      -0.125 * (dv.x * (2.0 * v.x + dv.x) + dv.y * (2.0 * v.y + dv.y) + dv.z * (2.0 * v.z + dv.z));
  Lanes const u_a = a.u + heat, u_b = b.u + heat;
  auto const rows_a = to_rows({a.p_x + 0.5 * dv.x, a.p_y + 0.5 * dv.y, a.p_z + 0.5 * dv.z, u_a});
  auto const rows_b = to_rows({b.p_x - 0.5 * dv.x, b.p_y - 0.5 * dv.y, b.p_z - 0.5 * dv.z, u_b});
  for (std::size_t l = 0; l < count; ++l) {
    store(rows_a[l], &particles[pair[l].i]);
    store(rows_b[l], &particles[pair[l].j]);
  }
  return a.caloric.in_reach(u_a) & b.caloric.in_reach(u_b);
}

/// Begins new expansions where `in_reach` has no bit. False when that fails.
bool renew(System& system, FluctuatingBlock& block, LocalPair const* pair, std::size_t count,
           unsigned in_reach, Failure& failure) {
  for (std::size_t l = 0; l < count; ++l)
    if (!(in_reach >> l & 1u))
      for (std::size_t const local : {pair[l].i, pair[l].j}) {
        auto const& particle = block.particles()[local];
        if (!particle.caloric.in_reach(particle.u) && !block.renew(system, local, failure))
          return false;
      }
  return true;
}

/// Sweeps one matching, whose inputs begin at `first`. False when a particle has left the equation of state.
bool sweep_matching(System& system, FluctuatingBlock& block, std::span<LocalPair const> pairs,
                    PairInputs const& inputs, std::size_t first, Sweep const& sweep, Failure& failure) {
  bool fine = true;
  for_each_group(pairs, block.size(), [&](LocalPair const* pair, std::size_t k, std::size_t count) {
    unsigned const in_reach =
        fluctuate_group(block.particles().data(), pair, inputs, first + k, count, sweep);
    if (in_reach != 0xffu) [[unlikely]]
      fine = fine && renew(system, block, pair, count, in_reach, failure);
  });
  return fine;
}

/// Calls f(begin, end, matchings begin, matchings end) for runs of whole matchings of some hundred pairs, so
/// that what is prepared for them stays in the cache.
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

void sweep_block(System& system, std::size_t number, NoiseSource const& source, Sweep const& sweep,
                 Failure& failure) {
  thread_local FluctuatingBlock block;
  thread_local PairInputs inputs;
  auto const& neighbours = system.neighbours;
  auto const pairs = neighbours.pairs(number);
  block.copy_in(system, number);
  for_each_run(neighbours.pair_ends(number), [&](std::uint32_t begin, std::uint32_t end,
                                                 std::span<std::uint32_t const> ends) {
    prepare_pairs(block, system.kernel, pairs.subspan(begin, end - begin), source, inputs);
    std::uint32_t at = begin;
    for (std::uint32_t const next : ends) {
      if (!sweep_matching(system, block, pairs.subspan(at, next - at), inputs, at - begin, sweep, failure))
        return;
      at = next;
    }
  });
  block.copy_out(system);
}

} // namespace

void fluctuate_ssa(System& system, double dt) {
  Sweep const sweep{system.friction, system.boltzmann, dt};
  sweep_all_blocks(system, [&](std::size_t block, NoiseSource const& source, Failure& failure) {
    sweep_block(system, block, source, sweep, failure);
  });
}

} // namespace mesobridge::sdpd
