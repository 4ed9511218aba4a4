#include "sdpd/step/fluctuation.hpp"
#include "sdpd/step/exact_pair.hpp"
#include "sdpd/step/fluctuation_isothermal.hpp"
#include "sdpd/step/pair_lanes.hpp"

namespace mesobridge::sdpd {
namespace {

/// Temperatures and inverse heat capacities of eight pairs at some energies.
struct ThermalLanes {
  Lanes T_a, T_b;
  FloatLanes inverse_C_a, inverse_C_b;

  [[gnu::always_inline]] ThermalLanes(ParticleLanes const& a, ParticleLanes const& b, Lanes const& u_a,
                                      Lanes const& u_b)
      : T_a(a.caloric.T(u_a)), T_b(b.caloric.T(u_b)), inverse_C_a(to_float(a.caloric.inverse_C(u_a))),
        inverse_C_b(to_float(b.caloric.inverse_C(u_b))) {}
};

template <class Law>
[[gnu::always_inline]] inline BathLanes::Directions
step_of(Sweep<Law> const& sweep, PairWeights<FloatLanes> const& weight, ThermalLanes const& at) {
  auto const bath = sweep.law.template bath<FloatLanes>(
      {to_float(at.T_a), to_float(at.T_b), at.inverse_C_a, at.inverse_C_b});
  return step_in(bath, sweep.law, weight, sweep.dt);
}

/// a/b where b > 0, and 1 where both vanish (at the edge of the kernel, where nothing happens).
[[gnu::always_inline]] inline FloatLanes ratio(FloatLanes const& a, FloatLanes const& b) {
  constexpr float tiny = 1e-37f;
  return (a + tiny) / (b + tiny);
}

/// The square of the noise that would lead back; that of the noise itself where there is no friction.
[[gnu::always_inline]] inline FloatLanes
square_over_variance(FloatLanes const& square, FloatLanes const& variance, FloatLanes const& noise2) {
  return variance > 0.0f ? square / variance : noise2;
}

/// The noise's part of the exponent a of theory sheet, section 3, EMS, as in ExactPair: G^2 less the square
/// of the noise that would lead back, and the widths' ratio |B|^2/|B'|^2.
struct NoiseTerms {
  FloatLanes squares, widths;
};
[[gnu::always_inline]] inline NoiseTerms noise_terms(BathLanes::Directions const& there,
                                                     BathLanes::Directions const& back,
                                                     InputLanes<Across::common> const& input,
                                                     VectorLanes<FloatLanes> const& v,
                                                     VectorLanes<FloatLanes> const& dv) {
  auto const& e = input.e;
  VectorLanes<FloatLanes> const moved{v.x + dv.x, v.y + dv.y, v.z + dv.z};
  VectorLanes<FloatLanes> const rest{dv.x + back.perp.decay * moved.x, dv.y + back.perp.decay * moved.y,
                                     dv.z + back.perp.decay * moved.z};
  FloatLanes const along = dot(e, dv) + back.par.decay * dot(e, moved), rest_along = dot(e, rest);
  FloatLanes const across2 = dot(rest, rest) - rest_along * rest_along;
  FloatLanes const noise2 =
      dot(input.G, input.G) - ratio(along * along, back.par.variance) - ratio(across2, back.perp.variance);
  FloatLanes const across_ratio = ratio(there.perp.variance, back.perp.variance);
  return {noise2, ratio(there.par.variance, back.par.variance) * across_ratio * across_ratio};
}
[[gnu::always_inline]] inline NoiseTerms noise_terms(BathLanes::Directions const& there,
                                                     BathLanes::Directions const& back,
                                                     InputLanes<Across::none> const& input,
                                                     VectorLanes<FloatLanes> const& v,
                                                     VectorLanes<FloatLanes> const& dv) {
  FloatLanes const along_dv = dot(input.e, dv), noise = dot(input.e, input.G), noise2 = noise * noise;
  FloatLanes const along = along_dv + back.par.decay * (dot(input.e, v) + along_dv);
  return {noise2 - square_over_variance(along * along, back.par.variance, noise2),
          ratio(there.par.variance, back.par.variance)};
}
/// Either friction may vanish alone, which must not leave a round-off of the other.
[[gnu::always_inline]] inline NoiseTerms noise_terms(BathLanes::Directions const& there,
                                                     BathLanes::Directions const& back,
                                                     InputLanes<Across::own> const& input,
                                                     VectorLanes<FloatLanes> const& v,
                                                     VectorLanes<FloatLanes> const& dv) {
  auto const &e = input.e, &G = input.G;
  VectorLanes<FloatLanes> const moved{v.x + dv.x, v.y + dv.y, v.z + dv.z};
  FloatLanes const along_dv = dot(e, dv), along_moved = dot(e, moved), noise = dot(e, G);
  FloatLanes const along = along_dv + back.par.decay * along_moved;
  auto across = [&](FloatLanes const& dv_k, FloatLanes const& moved_k, FloatLanes const& e_k) {
    return dv_k - along_dv * e_k + back.perp.decay * (moved_k - along_moved * e_k);
  };
  VectorLanes<FloatLanes> const side{across(dv.x, moved.x, e.x), across(dv.y, moved.y, e.y),
                                     across(dv.z, moved.z, e.z)};
  FloatLanes const noise2 = noise * noise, noise_across2 = dot(G, G) - noise2;
  FloatLanes const across_ratio = ratio(there.perp.variance, back.perp.variance);
  return {noise2 - square_over_variance(along * along, back.par.variance, noise2) + noise_across2 -
              square_over_variance(dot(side, side), back.perp.variance, noise_across2),
          ratio(there.par.variance, back.par.variance) * across_ratio * across_ratio};
}

/// The exponent a itself.
template <class Law>
[[gnu::always_inline]] inline FloatLanes log_acceptance(NoiseTerms const& noise, ParticleLanes const& a,
                                                        ParticleLanes const& b, ThermalLanes const& at,
                                                        ThermalLanes const& proposed, double boltzmann) {
  Lanes const log_a = logarithm(proposed.T_a / at.T_a), log_b = logarithm(proposed.T_b / at.T_b);
  Lanes const entropies = (a.caloric.entropy_change(at.T_a, proposed.T_a, log_a) +
                           b.caloric.entropy_change(at.T_b, proposed.T_b, log_b)) *
                          broadcast(1 / boltzmann);
  Lanes const widths = 0.5 * logarithm(to_double(noise.widths));
  if constexpr (Law::measure_over_T)
    return to_float(entropies - log_a - log_b + widths) + 0.5f * noise.squares;
  else
    return to_float(entropies + widths) + 0.5f * noise.squares;
}

/// What became of a group of pairs: one bit a lane.
struct GroupOutcome {
  unsigned made;  ///< the step was made
  unsigned exact; ///< it was not, and ExactPair has to make it: the caloric expansions do not reach so far
  unsigned renew; ///< it was, and a caloric expansion is out of reach now
  unsigned test;  ///< it was not, and the spare bits do not decide the Metropolis test
  unsigned out_of_domain;
};

[[gnu::always_inline]] inline unsigned positive(Lanes const& T_a, Lanes const& T_b) {
  return less(Lanes{}, T_a) & less(Lanes{}, T_b);
}

/// Lanes whose Metropolis test is passed for certain, and those for which more bits are needed.
struct Verdict {
  unsigned passed, open;
};
[[gnu::always_inline]] inline Verdict metropolis(FloatLanes const& log_acceptance,
                                                 std::uint32_t const* bits) {
  Lanes const level = to_double(exp_up_to_one(log_acceptance)) * double(1u << spare_bits);
  Lanes first;
  for (std::size_t l = 0; l < lane_count; ++l)
    first[l] = static_cast<std::int32_t>(bits[l]);
  unsigned const above = less(first, level),
                 passed = less(first + 1.0, level) | (0xffu & ~less(level, broadcast(1u << spare_bits)));
  return {passed & above, above & ~passed};
}

/// The steps of up to eight pairs that share no particle.
template <class Law, PairScheme scheme>
[[gnu::always_inline]] inline GroupOutcome
fluctuate_group(FluctuatingParticle* particles, LocalPair const* pair, PairInputs const& inputs,
                std::size_t first, std::size_t count, Sweep<Law> const& sweep) {
  ParticleLanes const a(load_lines([&](std::size_t l) { return &particles[pair[l].i]; }));
  ParticleLanes const b(load_lines([&](std::size_t l) { return &particles[pair[l].j]; }));
  InputLanes<Law::across> const input(inputs, first);
  Lanes const v_x = a.p_x - b.p_x, v_y = a.p_y - b.p_y, v_z = a.p_z - b.p_z;
  VectorLanes<FloatLanes> const v{to_float(v_x), to_float(v_y), to_float(v_z)};
  ThermalLanes const at(a, b, a.u, b.u);
  auto const there = step_of(sweep, input.weight, at);
  auto const change = velocity_change(there, input, v);
  Lanes const dv_x = to_double(change.x), dv_y = to_double(change.y), dv_z = to_double(change.z);
  Lanes const heat =
      -0.125 * (dv_x * (2.0 * v_x + dv_x) + dv_y * (2.0 * v_y + dv_y) + dv_z * (2.0 * v_z + dv_z));
  Lanes const u_a = a.u + heat, u_b = b.u + heat;
  ThermalLanes const proposed(a, b, u_a, u_b);
  unsigned const present = count == lane_count ? 0xffu : (1u << count) - 1;
  unsigned const in_reach = a.caloric.in_reach(proposed.T_a) & b.caloric.in_reach(proposed.T_b);
  unsigned const in_domain = positive(proposed.T_a, proposed.T_b);
  GroupOutcome outcome{
      .made = present, .exact = 0, .renew = present & ~(in_reach & in_domain), .test = 0, .out_of_domain = 0};
  if constexpr (scheme != PairScheme::ssa)
    outcome = {.made = present & in_reach & in_domain,
               .exact = present & ~in_reach,
               .renew = 0,
               .test = 0,
               .out_of_domain = present & in_reach & ~in_domain};
  if constexpr (scheme == PairScheme::ems) {
    auto const back = step_of(sweep, input.weight, proposed);
    auto const noise = noise_terms(there, back, input, v, change);
    auto const verdict =
        metropolis(log_acceptance<Law>(noise, a, b, at, proposed, sweep.law.boltzmann), &inputs.bits[first]);
    outcome.test = outcome.made & verdict.open;
    outcome.made &= verdict.passed;
  }
  auto const rows_a = to_rows({a.p_x + 0.5 * dv_x, a.p_y + 0.5 * dv_y, a.p_z + 0.5 * dv_z, u_a});
  auto const rows_b = to_rows({b.p_x - 0.5 * dv_x, b.p_y - 0.5 * dv_y, b.p_z - 0.5 * dv_z, u_b});
  auto write = [&](std::size_t l) {
    store(rows_a[l], &particles[pair[l].i]);
    store(rows_b[l], &particles[pair[l].j]);
  };
  if (outcome.made == 0xffu) [[likely]]
    for (std::size_t l = 0; l < lane_count; ++l)
      write(l);
  else
    for (std::size_t l = 0; l < count; ++l)
      if (outcome.made >> l & 1u)
        write(l);
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
    bool fine = true;
    for_each_group(pairs, block_.size(), [&](LocalPair const* pair, std::size_t k, std::size_t count) {
      auto const outcome =
          fluctuate_group<Law, scheme>(block_.particles().data(), pair, inputs_, first + k, count, sweep_);
      counts_.proposed += count;
      if (outcome.made != (1u << count) - 1 || outcome.renew != 0) [[unlikely]]
        fine = fine && finish(outcome, pair, first + k, count);
    });
    return fine;
  }

 private:
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
    double const weight = inputs_.weight[k];
    double const across = Law::across == Across::own ? inputs_.weight_across[k] : weight;
    ExactPair<Law>(system_, block_, pair)
        .step(scheme, {.e = {inputs_.e_x[k], inputs_.e_y[k], inputs_.e_z[k]}, .weight = {weight, across}},
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
  for_each_run(neighbours.pair_ends(number), [&](std::uint32_t begin, std::uint32_t end,
                                                 std::span<std::uint32_t const> ends) {
    prepare_pairs(system, sweep.law, block, pairs.subspan(begin, end - begin), sweep.noise.pairs, inputs);
    std::uint32_t at = begin;
    for (std::uint32_t const next : ends) {
      if (!in_lanes.matching(pairs.subspan(at, next - at), at - begin))
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
      break; // made below for every law
    }
}

} // namespace

void fluctuate(System& system, PairScheme scheme, double dt, bool second) {
  if (scheme == PairScheme::ser)
    return fluctuate_ser(system, dt, second);
  std::visit([&](auto const& law) { fluctuate(system, law, scheme, dt, second); }, system.law);
}

} // namespace mesobridge::sdpd
