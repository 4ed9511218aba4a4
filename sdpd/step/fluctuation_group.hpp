#pragma once
#include "sdpd/step/fluctuation_sweep.hpp"
#include "sdpd/step/metropolis_lanes.hpp"

/// The steps of a group of pairs that share no particle, by SSA, AMS or EMS.
namespace mesobridge::sdpd {

/// Pairs are worked on in groups of eight or, in two halves of double precision, of sixteen.
template <std::size_t halves>
using FloatsOf = std::conditional_t<halves == 2, WideFloats, FloatLanes>;
template <std::size_t halves>
using Halves = std::array<Lanes, halves>;

[[gnu::always_inline]] inline FloatLanes joined(Halves<1> const& x) {
  return to_float(x[0]);
}
[[gnu::always_inline]] inline WideFloats joined(Halves<2> const& x) {
  return join(to_float(x[0]), to_float(x[1]));
}
[[gnu::always_inline]] inline Lanes half(FloatLanes const& x, std::size_t) {
  return to_double(x);
}
[[gnu::always_inline]] inline Lanes half(WideFloats const& x, std::size_t h) {
  return to_double(h == 0 ? low_half(x) : high_half(x));
}

/// f(half) for each half of a group.
template <std::size_t halves, class F>
[[gnu::always_inline]] inline Halves<halves> each_half(F const& f) {
  if constexpr (halves == 1)
    return {f(0)};
  else
    return {f(0), f(1)};
}

/// Particles with caloric expansions of their own.
struct ExpandedParticles {
  using InLanes = ParticleLanes;
  FluctuatingParticle* particles;

  [[gnu::always_inline]] void* place(std::size_t local) const { return &particles[local]; }
  template <class LocalOf>
  [[gnu::always_inline]] InLanes load(LocalOf const& local_of) const {
    return InLanes(load_lines([&](std::size_t l) [[gnu::always_inline]] { return place(local_of(l)); }));
  }
};
/// Particles of one constant heat capacity C: rows of p and the energy C T.
struct ConstantCapacityParticles {
  using InLanes = ConstantCapacityLanes;
  Row* rows;
  double heat_capacity, inverse_heat_capacity;

  [[gnu::always_inline]] void* place(std::size_t local) const { return &rows[local]; }
  template <class LocalOf>
  [[gnu::always_inline]] InLanes load(LocalOf const& local_of) const {
    RowLanes const row = load_rows([&](std::size_t l) [[gnu::always_inline]] { return place(local_of(l)); });
    return {row[0], row[1], row[2], row[3], {heat_capacity, inverse_heat_capacity}};
  }
};

/// The particles on one side of a group's pairs.
template <class Particles, std::size_t halves>
using Side = std::array<typename Particles::InLanes, halves>;
template <std::size_t halves, class Particles, class LocalOf>
[[gnu::always_inline]] inline Side<Particles, halves> load_side(Particles const& particles,
                                                                LocalOf const& local_of) {
  auto half = [&](std::size_t h) [[gnu::always_inline]] {
    return particles.load([&](std::size_t l) [[gnu::always_inline]] { return local_of(h * lane_count + l); });
  };
  if constexpr (halves == 1)
    return {half(0)};
  else
    return {half(0), half(1)};
}

/// Temperatures and inverse heat capacities of the pairs at some energies.
template <class Particles, std::size_t halves>
struct Thermal {
  using OneSide = Side<Particles, halves>;
  Halves<halves> T_a, T_b;
  PairTemperatures<FloatsOf<halves>> rounded;

  [[gnu::always_inline]] Thermal(OneSide const& a, OneSide const& b, Halves<halves> const& u_a,
                                 Halves<halves> const& u_b)
      : T_a(each_half<halves>([&](std::size_t h) { return a[h].caloric.T(u_a[h]); })),
        T_b(each_half<halves>([&](std::size_t h) { return b[h].caloric.T(u_b[h]); })),
        rounded{joined(T_a), joined(T_b),
                joined(each_half<halves>([&](std::size_t h) { return a[h].caloric.inverse_C(u_a[h]); })),
                joined(each_half<halves>([&](std::size_t h) { return b[h].caloric.inverse_C(u_b[h]); }))} {}

  /// Bits of the pairs whose expansions serve at these temperatures.
  [[gnu::always_inline]] unsigned in_reach(OneSide const& a, OneSide const& b) const {
    return bits([&](std::size_t h) { return a[h].caloric.in_reach(T_a[h]) & b[h].caloric.in_reach(T_b[h]); });
  }
  [[gnu::always_inline]] unsigned positive() const {
    return bits([&](std::size_t h) { return less(Lanes{}, T_a[h]) & less(Lanes{}, T_b[h]); });
  }
  template <class F>
  [[gnu::always_inline]] static unsigned bits(F const& f) {
    if constexpr (halves == 1)
      return f(0);
    else
      return f(0) | f(1) << lane_count;
  }
};

template <class Law, class Floats>
[[gnu::always_inline]] inline typename Bath<Floats>::Directions
step_of(Sweep<Law> const& sweep, PairWeights<Floats> const& weight, PairTemperatures<Floats> const& at) {
  return step_in(sweep.law.template bath<Floats>(at), sweep.law, weight, sweep.dt);
}

/// The exponent a of theory sheet, section 3, EMS, as in ExactPair.
template <class Law, class Particles, std::size_t halves>
[[gnu::always_inline]] inline FloatsOf<halves>
log_acceptance(NoiseTerms<FloatsOf<halves>> const& noise, Side<Particles, halves> const& a,
               Side<Particles, halves> const& b, Thermal<Particles, halves> const& at,
               Thermal<Particles, halves> const& proposed, double boltzmann) {
  auto const exact = each_half<halves>([&](std::size_t h) [[gnu::always_inline]] {
    Lanes const log_a = logarithm(proposed.T_a[h] / at.T_a[h]),
                log_b = logarithm(proposed.T_b[h] / at.T_b[h]);
    Lanes const entropies = (a[h].caloric.entropy_change(at.T_a[h], proposed.T_a[h], log_a) +
                             b[h].caloric.entropy_change(at.T_b[h], proposed.T_b[h], log_b)) *
                            broadcast(1 / boltzmann);
    Lanes const widths = 0.5 * logarithm(half(noise.widths, h));
    if constexpr (Law::measure_over_T)
      return entropies - log_a - log_b + widths;
    else
      return entropies + widths;
  });
  return joined(exact) + 0.5f * noise.squares;
}

/// What became of a group of pairs: one bit a lane.
struct GroupOutcome {
  unsigned made;  ///< the step was made
  unsigned exact; ///< it was not, and ExactPair has to make it: the caloric expansions do not reach so far
  unsigned renew; ///< it was, and a caloric expansion is out of reach now
  unsigned test;  ///< it was not, and the spare bits do not decide the Metropolis test
  unsigned out_of_domain;
};

/// Lanes whose Metropolis test is passed for certain, and those for which more bits are needed.
struct Verdict {
  unsigned passed, open;
};
template <std::size_t halves>
[[gnu::always_inline]] inline Verdict metropolis(FloatsOf<halves> const& log_acceptance,
                                                 std::uint32_t const* bits) {
  auto const chance = exp_up_to_one(log_acceptance);
  auto verdict = [&](std::size_t h) [[gnu::always_inline]] {
    Lanes const level = half(chance, h) * double(1u << spare_bits);
    Lanes const first = __builtin_convertvector(load<IntLanes>(bits + h * lane_count), Lanes);
    unsigned const above = less(first, level),
                   passed = less(first + 1.0, level) | (0xffu & ~less(level, broadcast(1u << spare_bits)));
    return Verdict{passed & above, above & ~passed};
  };
  Verdict all = verdict(0);
  if constexpr (halves == 2) {
    Verdict const high = verdict(1);
    all = {all.passed | high.passed << lane_count, all.open | high.open << lane_count};
  }
  return all;
}

/// The steps of up to eight pairs for each half that share no particle.
template <class Law, PairScheme scheme, std::size_t halves, class Particles>
[[gnu::always_inline]] inline GroupOutcome fluctuate_group(Particles const& particles, LocalPair const* pair,
                                                           PairInputs const& inputs, std::size_t first,
                                                           std::size_t count, Sweep<Law> const& sweep) {
  using Floats = FloatsOf<halves>;
  using InLanes = typename Particles::InLanes;
  auto const a = load_side<halves>(particles, [&](std::size_t l) { return pair[l].i; });
  auto const b = load_side<halves>(particles, [&](std::size_t l) { return pair[l].j; });
  InputLanes<Law::across, Floats> const input(inputs, first);
  auto relative = [&](Lanes InLanes::*p) [[gnu::always_inline]] {
    return each_half<halves>([&](std::size_t h) { return a[h].*p - b[h].*p; });
  };
  auto const v_x = relative(&InLanes::p_x), v_y = relative(&InLanes::p_y), v_z = relative(&InLanes::p_z);
  VectorLanes<Floats> const v{joined(v_x), joined(v_y), joined(v_z)};
  auto energies = [&](Side<Particles, halves> const& side, auto const& heat) [[gnu::always_inline]] {
    return each_half<halves>([&](std::size_t h) { return side[h].u + heat(h); });
  };
  auto no_heat = [](std::size_t) { return Lanes{}; };
  Thermal<Particles, halves> const at(a, b, energies(a, no_heat), energies(b, no_heat));
  auto const there = step_of(sweep, input.weight, at.rounded);
  auto const change = velocity_change(there, input, v);
  auto const heat = each_half<halves>([&](std::size_t h) [[gnu::always_inline]] {
    Lanes const x = half(change.x, h), y = half(change.y, h), z = half(change.z, h);
    return -0.125 * (x * (2.0 * v_x[h] + x) + y * (2.0 * v_y[h] + y) + z * (2.0 * v_z[h] + z));
  });
  auto the_heat = [&](std::size_t h) { return heat[h]; };
  auto const u_a = energies(a, the_heat), u_b = energies(b, the_heat);
  Thermal<Particles, halves> const proposed(a, b, u_a, u_b);
  constexpr unsigned all = (1u << halves * lane_count) - 1;
  unsigned const present = (1u << count) - 1, in_reach = proposed.in_reach(a, b),
                 in_domain = proposed.positive();
  GroupOutcome outcome{
      .made = present, .exact = 0, .renew = present & ~(in_reach & in_domain), .test = 0, .out_of_domain = 0};
  if constexpr (scheme != PairScheme::ssa)
    outcome = {.made = present & in_reach & in_domain,
               .exact = present & ~in_reach,
               .renew = 0,
               .test = 0,
               .out_of_domain = present & in_reach & ~in_domain};
  if constexpr (scheme == PairScheme::ems) {
    auto const back = step_of(sweep, input.weight, proposed.rounded);
    auto const noise = noise_terms(there, back, input, v, change);
    auto const verdict = metropolis<halves>(
        log_acceptance<Law, Particles, halves>(noise, a, b, at, proposed, sweep.law.boltzmann),
        &inputs.bits[first]);
    outcome.test = outcome.made & verdict.open;
    outcome.made &= verdict.passed;
  }
#pragma GCC unroll 2
  for (std::size_t h = 0; h < halves; ++h) {
    Lanes const x = 0.5 * half(change.x, h), y = 0.5 * half(change.y, h), z = 0.5 * half(change.z, h);
    auto const rows_a = to_rows({a[h].p_x + x, a[h].p_y + y, a[h].p_z + z, u_a[h]});
    auto const rows_b = to_rows({b[h].p_x - x, b[h].p_y - y, b[h].p_z - z, u_b[h]});
    auto write = [&](std::size_t l) [[gnu::always_inline]] {
      store(rows_a[l], particles.place(pair[h * lane_count + l].i));
      store(rows_b[l], particles.place(pair[h * lane_count + l].j));
    };
    if (outcome.made == all) [[likely]]
      for (std::size_t l = 0; l < lane_count; ++l)
        write(l);
    else
      for (std::size_t l = 0; l < lane_count; ++l)
        if (outcome.made >> (h * lane_count + l) & 1u)
          write(l);
  }
  return outcome;
}

} // namespace mesobridge::sdpd
