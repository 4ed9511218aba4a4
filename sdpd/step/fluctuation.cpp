#include "sdpd/step/fluctuation.hpp"
#include "sdpd/step/exact_pair.hpp"
#include "sdpd/step/fluctuation_entropy.hpp"
#include "sdpd/step/fluctuation_hybrid.hpp"
#include "sdpd/step/fluctuation_implicit.hpp"
#include "sdpd/step/fluctuation_isothermal.hpp"
#include "sdpd/step/metropolis_lanes.hpp"

namespace mesobridge::sdpd {
namespace {

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

/// The particles on one side of a group's pairs.
template <std::size_t halves>
using Side = std::array<ParticleLanes, halves>;
template <class LineOf>
[[gnu::always_inline]] inline ParticleLanes load_half(LineOf const& line_of, std::size_t h) {
  return ParticleLanes(
      load_lines([&](std::size_t l) [[gnu::always_inline]] { return line_of(h * lane_count + l); }));
}
template <std::size_t halves, class LineOf>
[[gnu::always_inline]] inline Side<halves> load_side(LineOf const& line_of) {
  if constexpr (halves == 1)
    return {load_half(line_of, 0)};
  else
    return {load_half(line_of, 0), load_half(line_of, 1)};
}

/// Temperatures and inverse heat capacities of the pairs at some energies.
template <std::size_t halves>
struct Thermal {
  Halves<halves> T_a, T_b;
  PairTemperatures<FloatsOf<halves>> rounded;

  [[gnu::always_inline]] Thermal(Side<halves> const& a, Side<halves> const& b, Halves<halves> const& u_a,
                                 Halves<halves> const& u_b)
      : T_a(each_half<halves>([&](std::size_t h) { return a[h].caloric.T(u_a[h]); })),
        T_b(each_half<halves>([&](std::size_t h) { return b[h].caloric.T(u_b[h]); })),
        rounded{joined(T_a), joined(T_b),
                joined(each_half<halves>([&](std::size_t h) { return a[h].caloric.inverse_C(u_a[h]); })),
                joined(each_half<halves>([&](std::size_t h) { return b[h].caloric.inverse_C(u_b[h]); }))} {}

  /// Bits of the pairs whose expansions serve at these temperatures.
  [[gnu::always_inline]] unsigned in_reach(Side<halves> const& a, Side<halves> const& b) const {
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
template <class Law, std::size_t halves>
[[gnu::always_inline]] inline FloatsOf<halves>
log_acceptance(NoiseTerms<FloatsOf<halves>> const& noise, Side<halves> const& a, Side<halves> const& b,
               Thermal<halves> const& at, Thermal<halves> const& proposed, double boltzmann) {
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
template <class Law, PairScheme scheme, std::size_t halves>
[[gnu::always_inline]] inline GroupOutcome
fluctuate_group(FluctuatingParticle* particles, LocalPair const* pair, PairInputs const& inputs,
                std::size_t first, std::size_t count, Sweep<Law> const& sweep) {
  using Floats = FloatsOf<halves>;
  auto const a = load_side<halves>([&](std::size_t l) { return &particles[pair[l].i]; });
  auto const b = load_side<halves>([&](std::size_t l) { return &particles[pair[l].j]; });
  InputLanes<Law::across, Floats> const input(inputs, first);
  auto relative = [&](Lanes ParticleLanes::*p) [[gnu::always_inline]] {
    return each_half<halves>([&](std::size_t h) { return a[h].*p - b[h].*p; });
  };
  auto const v_x = relative(&ParticleLanes::p_x), v_y = relative(&ParticleLanes::p_y),
             v_z = relative(&ParticleLanes::p_z);
  VectorLanes<Floats> const v{joined(v_x), joined(v_y), joined(v_z)};
  auto energies = [&](Side<halves> const& side, auto const& heat) [[gnu::always_inline]] {
    return each_half<halves>([&](std::size_t h) { return side[h].u + heat(h); });
  };
  auto no_heat = [](std::size_t) { return Lanes{}; };
  Thermal<halves> const at(a, b, energies(a, no_heat), energies(b, no_heat));
  auto const there = step_of(sweep, input.weight, at.rounded);
  auto const change = velocity_change(there, input, v);
  auto const heat = each_half<halves>([&](std::size_t h) [[gnu::always_inline]] {
    Lanes const x = half(change.x, h), y = half(change.y, h), z = half(change.z, h);
    return -0.125 * (x * (2.0 * v_x[h] + x) + y * (2.0 * v_y[h] + y) + z * (2.0 * v_z[h] + z));
  });
  auto the_heat = [&](std::size_t h) { return heat[h]; };
  auto const u_a = energies(a, the_heat), u_b = energies(b, the_heat);
  Thermal<halves> const proposed(a, b, u_a, u_b);
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
        log_acceptance<Law, halves>(noise, a, b, at, proposed, sweep.law.boltzmann), &inputs.bits[first]);
    outcome.test = outcome.made & verdict.open;
    outcome.made &= verdict.passed;
  }
#pragma GCC unroll 2
  for (std::size_t h = 0; h < halves; ++h) {
    Lanes const x = 0.5 * half(change.x, h), y = 0.5 * half(change.y, h), z = 0.5 * half(change.z, h);
    auto const rows_a = to_rows({a[h].p_x + x, a[h].p_y + y, a[h].p_z + z, u_a[h]});
    auto const rows_b = to_rows({b[h].p_x - x, b[h].p_y - y, b[h].p_z - z, u_b[h]});
    auto write = [&](std::size_t l) [[gnu::always_inline]] {
      store(rows_a[l], &particles[pair[h * lane_count + l].i]);
      store(rows_b[l], &particles[pair[h * lane_count + l].j]);
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

/// One block while it is swept.
template <class Law, PairScheme scheme>
class BlockSweep {
 public:
  BlockSweep(System& system, FluctuatingBlock& block, PairInputs& inputs, Sweep<Law> const& sweep,
             PairCounts& counts, Failure& failure)
      : system_(system), block_(block), inputs_(inputs), sweep_(sweep), counts_(counts), failure_(failure) {}

  /// Sweeps one matching, whose inputs begin at `first`. False when a particle has left the equation of
  /// state.
  bool matching(std::span<LocalPair const> pairs, std::size_t first) {
    std::size_t k = 0;
    for (; pairs.size() - k >= wide_count; k += wide_count)
      if (!group<2>(&pairs[k], first + k, wide_count))
        return false;
    std::size_t const left = pairs.size() - k;
    if (left == 0)
      return true;
    std::array<LocalPair, wide_count> last;
    auto const phantom = static_cast<std::uint16_t>(block_.size());
    last.fill({phantom, static_cast<std::uint16_t>(phantom + 1)});
    std::copy_n(&pairs[k], left, last.begin());
    return left <= lane_count ? group<1>(last.data(), first + k, left)
                              : group<2>(last.data(), first + k, left);
  }

 private:
  template <std::size_t halves>
  bool group(LocalPair const* pair, std::size_t first, std::size_t count) {
    auto const outcome =
        fluctuate_group<Law, scheme, halves>(block_.particles().data(), pair, inputs_, first, count, sweep_);
    counts_.proposed += count;
    if (outcome.made == (1u << count) - 1 && outcome.renew == 0) [[likely]]
      return true;
    return finish(outcome, pair, first, count);
  }
  /// Whatever the lanes could not do.
  bool finish(GroupOutcome const& outcome, LocalPair const* pair, std::size_t first, std::size_t count) {
    for (std::size_t l = 0; l < count; ++l) {
      unsigned const bit = 1u << l;
      if (outcome.out_of_domain & bit)
        ++counts_.out_of_domain;
      else if ((outcome.exact | outcome.test) & bit)
        exact_step(pair[l], first + l);
      else if (!((outcome.made | outcome.renew) & bit))
        ++counts_.metropolis;
      if (((outcome.exact | outcome.test | outcome.renew) & bit) && !(renew(pair[l].i) && renew(pair[l].j)))
        return false;
    }
    return true;
  }
  bool renew(std::size_t local) {
    auto const& [p, u, caloric] = block_.particles()[local];
    return (caloric.in_reach(u) && caloric.T(u) > 0) || block_.renew(system_, local, failure_);
  }
  void exact_step(LocalPair pair, std::size_t k) {
    auto const a = block_.ids()[pair.i], b = block_.ids()[pair.j];
    double const uniform =
        acceptance_uniform(sweep_.noise.acceptance, std::min(a, b), std::max(a, b), inputs_.bits[k]);
    double const par = inputs_.weight[k];
    double perp = Law::across == Across::none ? 0 : par;
    if constexpr (Law::across == Across::own)
      perp = inputs_.weight_across[k];
    ExactPair<Law>(system_, block_, pair)
        .step(scheme, {.e = {inputs_.e_x[k], inputs_.e_y[k], inputs_.e_z[k]}, .weight = {par, perp}},
              {.G = {inputs_.G_x[k], inputs_.G_y[k], inputs_.G_z[k]}, .uniform = uniform}, sweep_, counts_);
  }

  System& system_;
  FluctuatingBlock& block_;
  PairInputs& inputs_;
  Sweep<Law> const& sweep_;
  PairCounts& counts_;
  Failure& failure_;
};

template <class Law, PairScheme scheme>
void sweep_block(System& system, std::size_t number, Sweep<Law> const& sweep, PairCounts& counts,
                 Failure& failure) {
  thread_local FluctuatingBlock block;
  thread_local PairInputs inputs;
  auto const& neighbours = system.neighbours;
  auto const pairs = neighbours.pairs(number);
  block.copy_in(system, number);
  BlockSweep<Law, scheme> in_lanes(system, block, inputs, sweep, counts, failure);
  bool fine = true;
  for_each_run(neighbours.pair_ends(number), [&](std::uint32_t begin, std::uint32_t end,
                                                 std::span<std::uint32_t const> ends) {
    if (!fine)
      return;
    prepare_pairs(system, sweep.law, block, pairs.subspan(begin, end - begin), sweep.noise.pairs, inputs);
    std::uint32_t at = begin;
    for (std::uint32_t const next : ends) {
      fine = in_lanes.matching(pairs.subspan(at, next - at), at - begin);
      if (!fine)
        return;
      at = next;
    }
  });
  block.copy_out(system);
}

template <PairScheme scheme, class Law>
void fluctuate(System& system, Law const& law, double dt, bool second) {
  sweep_all_blocks(system, law, dt, second,
                   [&](std::size_t block, Sweep<Law> const& sweep, PairCounts& counts, Failure& failure) {
                     sweep_block<Law, scheme>(system, block, sweep, counts, failure);
                   });
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
