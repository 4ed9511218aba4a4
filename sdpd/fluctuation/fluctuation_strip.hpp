#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/scaled_velocity.hpp"
#include "sdpd/fluctuation/strip.hpp"

namespace mesobridge::sdpd {

/// A strip of pairs whose relative velocities, scaled where masses differ, friction and noise change.
template <class Particles>
class alignas(64) FluctuationStrip : public Strip<Particles, Gains::equal> {
 public:
  void read(Particles const& particles, std::span<LocalPair const> pairs, std::size_t phantom) {
    this->read_pairs(particles, pairs, phantom,
                     [&](std::size_t k, auto const& a, auto const& b) [[gnu::always_inline]] {
                       auto const v = relative_velocity(particles, k, a, b);
                       store(v.x, &v_x_[k]), store(v.y, &v_y_[k]), store(v.z, &v_z_[k]);
                     });
  }

  /// Finds the changes of the relative velocities; the inputs are those from `first` on.
  template <PairScheme scheme, class Law>
  void propose(PairInputs const& inputs, std::size_t first, Sweep<Law> const& sweep) {
    for (std::size_t k = 0; k < count_; k += wide_count) {
      InputLanes<Law::across, WideFloats> const input(inputs, first + k);
      auto const there = step_of(sweep, input.weight, this->thermal(k, Base::no_heat).rounded);
      auto const change = velocity_change(there, input, velocity(k));
      store(change.x, &change_x_[k]), store(change.y, &change_y_[k]), store(change.z, &change_z_[k]);
      if constexpr (scheme == PairScheme::ems)
        store(there.par.variance, &variance_par_[k]), store(there.perp.variance, &variance_perp_[k]);
    }
  }

  /// Finds the heat that the changes set free, and which of them can be made.
  template <PairScheme scheme>
  void judge() {
    for (std::size_t k = 0; k < count_; k += wide_count) {
      auto const heat = each_half(k, [&](std::size_t n) [[gnu::always_inline]] { return heat_of(n); });
      store(heat[0], &heat_[k]), store(heat[1], &heat_[k + lane_count]);
      outcomes_[k / wide_count] = this->template outcome_of<scheme>(k);
    }
  }

  /// Metropolis's test of EMS for the steps that are made so far, with the exponent a of
  /// sdpd/README.md, Eq. (S24), as in ExactPair.
  template <class Law>
  void test(PairInputs const& inputs, std::size_t first, Sweep<Law> const& sweep) {
    for (std::size_t k = 0; k < count_; k += wide_count) {
      InputLanes<Law::across, WideFloats> const input(inputs, first + k);
      auto const back = step_of(sweep, input.weight, this->thermal(k, this->heat_there()).rounded);
      auto const noise =
          noise_terms<WideFloats>({load<WideFloats>(&variance_par_[k]), load<WideFloats>(&variance_perp_[k])},
                                  back, input, velocity(k), change(k));
      store(noise.squares, &noise_squares_[k]), store(noise.widths, &noise_widths_[k]);
    }
    this->template test_outcomes<Law>(
        inputs, first, sweep.law.boltzmann, [&](std::size_t k) [[gnu::always_inline]] {
          return 0.5f *
                 (logarithm(load<WideFloats>(&noise_widths_[k])) + load<WideFloats>(&noise_squares_[k]));
        });
  }

  /// Gives the steps that are made to the particles.
  void write(Particles const& particles) const {
    for (std::size_t k = 0; k < count_; k += lane_count) {
      auto half = [&](StripFloats const& change) [[gnu::always_inline]] {
        return momentum_change(k, to_double(load<FloatLanes>(&change[k])));
      };
      auto const rows = to_rows({half(change_x_), half(change_y_), half(change_z_), load<Lanes>(&heat_[k])});
      this->for_each_made(k, [&](std::size_t pair, std::size_t l) [[gnu::always_inline]] {
        void *const a = particles.place(pairs_[pair].i), *const b = particles.place(pairs_[pair].j);
        store(load<Row>(a) + rows[l], a);
        store(load<Row>(b) + rows[l] * Row{-1, -1, -1, 1}, b);
      });
    }
  }

 private:
  static constexpr bool unit_masses = Particles::have_unit_masses;

  [[gnu::always_inline]] VectorLanes<Lanes> relative_velocity(Particles const& particles, std::size_t k,
                                                              auto const& a, auto const& b) {
    if constexpr (unit_masses) {
      return {a.p_x - b.p_x, a.p_y - b.p_y, a.p_z - b.p_z};
    } else {
      auto const scale = scale_of(*particles.masses, &pairs_[k]);
      store(scale.root, &root_mass_[k]);
      return {scale.velocity(a.p_x, b.p_x), scale.velocity(a.p_y, b.p_y), scale.velocity(a.p_z, b.p_z)};
    }
  }
  [[gnu::always_inline]] Lanes momentum_change(std::size_t k, Lanes const& velocity_change) const {
    if constexpr (unit_masses)
      return 0.5 * velocity_change;
    else
      return 0.5 * velocity_change * load<Lanes>(&root_mass_[k]);
  }

  using Base = Strip<Particles, Gains::equal>;
  using Base::count_, Base::pairs_, Base::heat_, Base::outcomes_;

  template <class Law>
  [[gnu::always_inline]] static auto step_of(Sweep<Law> const& sweep, PairWeights<WideFloats> const& weight,
                                             PairTemperatures<WideFloats> const& at) {
    return step_in(sweep.law.template bath<WideFloats>(at), sweep.law, weight, sweep.dt);
  }
  [[gnu::always_inline]] VectorLanes<WideFloats> velocity(std::size_t k) const {
    auto part = [&](StripNumbers const& v) [[gnu::always_inline]] {
      return rounded(each_half(k, [&](std::size_t n) { return load<Lanes>(&v[n]); }));
    };
    return {part(v_x_), part(v_y_), part(v_z_)};
  }
  [[gnu::always_inline]] VectorLanes<WideFloats> change(std::size_t k) const {
    return {load<WideFloats>(&change_x_[k]), load<WideFloats>(&change_y_[k]),
            load<WideFloats>(&change_z_[k])};
  }
  /// What the change of eight pairs' kinetic energies leaves for each of their particles.
  [[gnu::always_inline]] Lanes heat_of(std::size_t k) const {
    auto work = [&](StripNumbers const& v, StripFloats const& change) [[gnu::always_inline]] {
      Lanes const x = to_double(load<FloatLanes>(&change[k]));
      return x * (2.0 * load<Lanes>(&v[k]) + x);
    };
    return -0.125 * (work(v_x_, change_x_) + work(v_y_, change_y_) + work(v_z_, change_z_));
  }

  alignas(64) StripNumbers v_x_{}, v_y_{}, v_z_{};
  alignas(64) StripFloats change_x_{}, change_y_{}, change_z_{}, variance_par_{}, variance_perp_{},
      noise_squares_{}, noise_widths_{};
  struct Nothing {};
  [[no_unique_address]] std::conditional_t<unit_masses, Nothing, StripNumbers> root_mass_{};
};

} // namespace mesobridge::sdpd
