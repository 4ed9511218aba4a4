#pragma once
#include "sdpd/fluctuation/metropolis_lanes.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/sweep.hpp"

/// The steps of a strip of pairs that share no particle, by SSA, AMS or EMS. One pair's step is a long chain
/// of operations that wait for each other. So a strip is taken through it in short loops: the processor sees
/// some turns of a short loop at once and works on them together.
namespace mesobridge::sdpd {

inline constexpr std::size_t strip_length = 128;
static_assert(strip_length % wide_count == 0);

/// One quantity of a strip's pairs, in double or single precision.
using StripNumbers = std::array<double, strip_length>;
using StripFloats = std::array<float, strip_length>;

/// Two halves in double precision of sixteen numbers.
using Halves = std::array<Lanes, 2>;

/// f(k) for both halves of the sixteen pairs that begin at `first`.
template <class F>
[[gnu::always_inline]] inline Halves each_half(std::size_t first, F const& f) {
  return {f(first), f(first + lane_count)};
}
[[gnu::always_inline]] inline WideFloats rounded(Halves const& x) {
  return join(to_float(x[0]), to_float(x[1]));
}
[[gnu::always_inline]] inline Halves halves(WideFloats const& x) {
  return {to_double(low_half(x)), to_double(high_half(x))};
}
/// One bit a lane.
[[gnu::always_inline]] inline unsigned join(std::array<unsigned, 2> const& bits) {
  return bits[0] | bits[1] << lane_count;
}

/// Particles with caloric expansions of their own.
struct ExpandedParticles {
  static constexpr bool have_unit_masses = true;
  FluctuatingParticle* particles;

  [[gnu::always_inline]] void* place(std::size_t local) const { return &particles[local]; }
  [[gnu::always_inline]] void add_heat(std::size_t local, double heat) const { particles[local].u += heat; }
  template <class LocalOf>
  [[gnu::always_inline]] ParticleLanes load(LocalOf const& local_of) const {
    return ParticleLanes(
        load_lines([&](std::size_t l) [[gnu::always_inline]] { return place(local_of(l)); }));
  }

  struct StripCaloric {
    StripNumbers T_0, inverse_C_0, curvature, limit;

    [[gnu::always_inline]] void set(std::size_t k, CaloricLanes const& caloric) {
      store(caloric.T_0, &T_0[k]), store(caloric.inverse_C_0, &inverse_C_0[k]);
      store(caloric.curvature, &curvature[k]), store(caloric.limit, &limit[k]);
    }
    [[gnu::always_inline]] CaloricLanes at(std::size_t k) const {
      return {sdpd::load<Lanes>(&T_0[k]), sdpd::load<Lanes>(&inverse_C_0[k]),
              sdpd::load<Lanes>(&curvature[k]), sdpd::load<Lanes>(&limit[k])};
    }
  };
};

/// The same with masses of their own.
struct OwnMassParticles : ExpandedParticles {
  static constexpr bool have_unit_masses = false;
  OwnMasses const* masses;
};

/// Particles of one constant heat capacity C: rows of p and the energy C T.
struct ConstantCapacityParticles {
  static constexpr bool have_unit_masses = true;
  Row* rows;
  ConstantCaloric caloric;

  [[gnu::always_inline]] void* place(std::size_t local) const { return &rows[local]; }
  [[gnu::always_inline]] void add_heat(std::size_t local, double heat) const { rows[local][3] += heat; }
  template <class LocalOf>
  [[gnu::always_inline]] ConstantCapacityLanes load(LocalOf const& local_of) const {
    RowLanes const row = load_rows([&](std::size_t l) [[gnu::always_inline]] { return place(local_of(l)); });
    return {row[0], row[1], row[2], row[3], caloric};
  }

  struct StripCaloric {
    ConstantCaloric caloric;

    [[gnu::always_inline]] void set(std::size_t, ConstantCaloric const& of_all) { caloric = of_all; }
    [[gnu::always_inline]] ConstantCaloric at(std::size_t) const { return caloric; }
  };
};

/// What became of sixteen pairs: one bit a lane.
struct GroupOutcome {
  unsigned made;  ///< the step was made
  unsigned exact; ///< it was not, and ExactPair or ExactHeat has to make it: the caloric expansions do not
                  ///< reach so far
  unsigned renew; ///< it was, and took a particle beyond its caloric expansion or to T <= 0
  unsigned test;  ///< it was not, and the spare bits do not decide the Metropolis test
  unsigned out_of_domain;
};

/// Temperatures and inverse heat capacities of sixteen pairs.
struct PairsThermal {
  Halves T_a, T_b;
  PairTemperatures<WideFloats> rounded;
};

/// How a pair's heat goes to its particles: both get it (what kinetic energy sets free), or the second gives
/// it to the first.
enum class Gains { equal, opposite };

/// What the strips of every kind of step share. Lanes past the last pair hold phantoms or an earlier strip's
/// pairs: nothing of them is used.
template <class Particles, Gains gains>
class alignas(64) Strip {
 public:
  /// Calls f(number of the pair, its group's outcome, its bit) for all pairs of the groups in which some are
  /// not done with, until it returns false; returns whether it never did.
  template <class F>
  bool for_each_open(F const& f) const {
    for (std::size_t k = 0; k < count_; k += wide_count) {
      std::size_t const present = std::min(count_ - k, wide_count);
      GroupOutcome const& outcome = outcomes_[k / wide_count];
      if (outcome.made == (1u << present) - 1 && outcome.renew == 0) [[likely]]
        continue;
      for (std::size_t l = 0; l < present; ++l)
        if (!f(k + l, outcome, 1u << l))
          return false;
    }
    return true;
  }

 protected:
  struct Side {
    StripNumbers u;
    typename Particles::StripCaloric caloric;
  };

  /// Takes in pairs, at most strip_length of them, and for every eight of them calls begin(k, a, b) with the
  /// particles they are pairs of.
  template <class Begin>
  [[gnu::always_inline]] void read_pairs(Particles const& particles, std::span<LocalPair const> pairs,
                                         std::size_t phantom, Begin const& begin) {
    count_ = pairs.size();
    std::copy(pairs.begin(), pairs.end(), pairs_.begin());
    std::size_t const whole = (count_ + lane_count - 1) / lane_count * lane_count;
    std::fill(pairs_.begin() + static_cast<std::ptrdiff_t>(count_),
              pairs_.begin() + static_cast<std::ptrdiff_t>(whole),
              LocalPair{static_cast<std::uint16_t>(phantom), static_cast<std::uint16_t>(phantom + 1)});
    for (std::size_t k = 0; k < count_; k += lane_count) {
      auto const a = particles.load([&](std::size_t l) [[gnu::always_inline]] { return pairs_[k + l].i; });
      auto const b = particles.load([&](std::size_t l) [[gnu::always_inline]] { return pairs_[k + l].j; });
      begin(k, a, b);
      store(a.u, &a_.u[k]), store(b.u, &b_.u[k]);
      a_.caloric.set(k, a.caloric), b_.caloric.set(k, b.caloric);
    }
  }

  /// Calls add(number of the pair, its lane) for the pairs among the eight from k on whose step is made.
  template <class Add>
  [[gnu::always_inline]] void for_each_made(std::size_t k, Add const& add) const {
    unsigned const made = outcomes_[k / wide_count].made >> (k % wide_count) & 0xffu;
    if (made == 0xffu) [[likely]]
      for (std::size_t l = 0; l < lane_count; ++l)
        add(k + l, l);
    else
      for (std::size_t l = 0; l < lane_count; ++l)
        if (made >> l & 1u)
          add(k + l, l);
  }

  /// A function object and no function: a pointer to a function would not be inlined where it is handed on.
  static constexpr auto no_heat = [](std::size_t) [[gnu::always_inline]] { return Lanes{}; };
  [[gnu::always_inline]] auto heat_there() const {
    return [this](std::size_t k) [[gnu::always_inline]] { return load<Lanes>(&heat_[k]); };
  }
  /// What becomes of the sixteen pairs from k on when their particles gain heat_.
  template <PairScheme scheme>
  [[gnu::always_inline]] GroupOutcome outcome_of(std::size_t k) const {
    PairsThermal const proposed = thermal(k, heat_there());
    auto bits = [&](auto const& f) [[gnu::always_inline]] {
      return join(std::array{f(k, 0), f(k + lane_count, 1)});
    };
    unsigned const present = count_ - k < wide_count ? (1u << (count_ - k)) - 1 : 0xffffu;
    unsigned const in_reach = bits([&](std::size_t n, std::size_t h) [[gnu::always_inline]] {
      return a_.caloric.at(n).in_reach(proposed.T_a[h]) & b_.caloric.at(n).in_reach(proposed.T_b[h]);
    });
    unsigned const in_domain = bits([&](std::size_t, std::size_t h) [[gnu::always_inline]] {
      return less(Lanes{}, proposed.T_a[h]) & less(Lanes{}, proposed.T_b[h]);
    });
    if constexpr (scheme == PairScheme::ssa)
      return {.made = present,
              .exact = 0,
              .renew = present & ~(in_reach & in_domain),
              .test = 0,
              .out_of_domain = 0};
    else
      return {.made = present & in_reach & in_domain,
              .exact = present & ~in_reach,
              .renew = 0,
              .test = 0,
              .out_of_domain = present & in_reach & ~in_domain};
  }
  /// The pairs' state when their particles have gained some heat.
  template <class Heat>
  [[gnu::always_inline]] PairsThermal thermal(std::size_t k, Heat const& heat) const {
    auto of_b = [&](std::size_t n)
                    [[gnu::always_inline]] { return gains == Gains::equal ? heat(n) : -heat(n); };
    auto T = [&](Side const& side, auto const& gain) [[gnu::always_inline]] {
      return each_half(k, [&](std::size_t n) [[gnu::always_inline]] {
        return side.caloric.at(n).T(load<Lanes>(&side.u[n]) + gain(n));
      });
    };
    auto inverse_C = [&](Side const& side, auto const& gain) [[gnu::always_inline]] {
      return rounded(each_half(k, [&](std::size_t n) [[gnu::always_inline]] {
        return side.caloric.at(n).inverse_C(load<Lanes>(&side.u[n]) + gain(n));
      }));
    };
    Halves const T_a = T(a_, heat), T_b = T(b_, of_b);
    return {T_a, T_b, {rounded(T_a), rounded(T_b), inverse_C(a_, heat), inverse_C(b_, of_b)}};
  }
  /// Metropolis's test of EMS for the steps that are made so far; noise(k) is the part of the exponent that
  /// their noise has.
  template <class Law, class Noise>
  [[gnu::always_inline]] void test_outcomes(PairInputs const& inputs, std::size_t first, double boltzmann,
                                            Noise const& noise) {
    for (std::size_t k = 0; k < count_; k += wide_count) {
      GroupOutcome& outcome = outcomes_[k / wide_count];
      auto const verdict = metropolis(log_measure<Law>(k, boltzmann) + noise(k), &inputs.bits[first + k]);
      outcome.test = outcome.made & verdict.open;
      outcome.made &= verdict.passed;
    }
  }

  /// Change of the logarithm of the invariant measure.
  template <class Law>
  [[gnu::always_inline]] WideFloats log_measure(std::size_t k, double boltzmann) const {
    auto const at = thermal(k, no_heat), proposed = thermal(k, heat_there());
    auto exact = [&](std::size_t n, std::size_t h) [[gnu::always_inline]] {
      auto const [entropy, log_T] = pair_change(a_.caloric.at(n), b_.caloric.at(n), at.T_a[h], at.T_b[h],
                                                proposed.T_a[h], proposed.T_b[h]);
      Lanes const entropies = entropy * broadcast(1 / boltzmann);
      if constexpr (Law::measure_over_T)
        return entropies - log_T;
      else
        return entropies;
    };
    return rounded({exact(k, 0), exact(k + lane_count, 1)});
  }

  /// Lanes whose Metropolis test is passed for certain, and those for which more bits are needed.
  struct Verdict {
    unsigned passed, open;
  };
  [[gnu::always_inline]] static Verdict metropolis(WideFloats const& log_acceptance,
                                                   std::uint32_t const* bits) {
    Halves const chance = halves(exp_up_to_one(log_acceptance));
    std::array<unsigned, 2> passed, open;
    for (std::size_t h = 0; h < 2; ++h) {
      Lanes const level = chance[h] * double(1u << spare_bits);
      Lanes const first = __builtin_convertvector(load<IntLanes>(bits + h * lane_count), Lanes);
      unsigned const above = less(first, level),
                     sure = less(first + 1.0, level) | (0xffu & ~less(level, broadcast(1u << spare_bits)));
      passed[h] = sure & above, open[h] = above & ~sure;
    }
    return {join(passed), join(open)};
  }

  std::size_t count_ = 0;
  alignas(64) std::array<LocalPair, strip_length> pairs_{};
  alignas(64) StripNumbers heat_{};
  Side a_{}, b_{};
  std::array<GroupOutcome, strip_length / wide_count> outcomes_{};
};

} // namespace mesobridge::sdpd
