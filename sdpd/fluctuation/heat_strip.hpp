#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/strip.hpp"

namespace mesobridge::sdpd {

/// A strip of pairs that conduct heat, which the second particle gives to the first.
template <class Particles>
class alignas(64) HeatStrip : public Strip<Particles, Gains::opposite> {
 public:
  void read(Particles const& particles, std::span<LocalPair const> pairs, std::size_t phantom) {
    this->read_pairs(particles, pairs, phantom, [](std::size_t, auto const&, auto const&) {});
  }

  /// Finds the heat; the inputs are those from `first` on.
  template <PairScheme scheme, class Law>
  void propose(PairInputs const& inputs, std::size_t first, Sweep<Law> const& sweep) {
    for (std::size_t k = 0; k < count_; k += wide_count) {
      auto const there = step_of(inputs, first, sweep, k, Base::no_heat);
      auto const heat = halves(there.mean + square_root(there.variance) * noise(inputs, first + k));
      store(heat[0], &heat_[k]), store(heat[1], &heat_[k + lane_count]);
      if constexpr (scheme == PairScheme::ems)
        store(there.variance, &variance_[k]);
    }
  }

  /// Finds which of the steps can be made.
  template <PairScheme scheme>
  void judge() {
    for (std::size_t k = 0; k < count_; k += wide_count)
      outcomes_[k / wide_count] = this->template outcome_of<scheme>(k);
  }

  /// Metropolis's test of EMS for the steps that are made so far, as in ExactHeat.
  template <class Law>
  void test(PairInputs const& inputs, std::size_t first, Sweep<Law> const& sweep) {
    this->template test_outcomes<Law>(
        inputs, first, sweep.law.boltzmann, [&](std::size_t k) [[gnu::always_inline]] {
          auto const back = step_of(inputs, first, sweep, k, this->heat_there());
          WideFloats const G = noise(inputs, first + k), noise2 = G * G;
          WideFloats const heat = rounded({load<Lanes>(&heat_[k]), load<Lanes>(&heat_[k + lane_count])});
          WideFloats const rest = heat + back.mean;
          return 0.5f * (logarithm(ratio(load<WideFloats>(&variance_[k]), back.variance)) + noise2 -
                         square_over_variance(rest * rest, back.variance, noise2));
        });
  }

  /// Gives the steps that are made to the particles.
  void write(Particles const& particles) const {
    for (std::size_t k = 0; k < count_; k += lane_count)
      this->for_each_made(k, [&](std::size_t pair, std::size_t) [[gnu::always_inline]] {
        particles.add_heat(pairs_[pair].i, heat_[pair]);
        particles.add_heat(pairs_[pair].j, -heat_[pair]);
      });
  }

 private:
  using Base = Strip<Particles, Gains::opposite>;
  using Base::count_, Base::pairs_, Base::heat_, Base::outcomes_;

  [[gnu::always_inline]] static WideFloats noise(PairInputs const& inputs, std::size_t k) {
    return load<WideFloats>(&inputs.G_x[k]);
  }
  /// The law of the sixteen pairs from k on when they have exchanged `heat`. Their difference of temperatures
  /// is taken in double precision: it may be small.
  template <class Law, class Heat>
  [[gnu::always_inline]] HeatStep<WideFloats> step_of(PairInputs const& inputs, std::size_t first,
                                                      Sweep<Law> const& sweep, std::size_t k,
                                                      Heat const& heat) const {
    auto const at = this->thermal(k, heat);
    WideFloats const difference = rounded({at.T_a[0] - at.T_b[0], at.T_a[1] - at.T_b[1]});
    return sweep.law.step(load<WideFloats>(&inputs.weight[first + k]), sweep.dt, at.rounded, difference);
  }

  alignas(64) StripFloats variance_{};
};

} // namespace mesobridge::sdpd
