#pragma once
#include "fitting/eos/mixture.hpp"
#include "fitting/eos/packed.hpp"

namespace mesobridge::fitting {

/// As MixtureSplit.
struct PackedSplit {
  Pack T, log_density_ratio;
};

/// Whether a model has isochores of packs that say all that a mixture asks.
template <class E>
concept PackedPart = PackedModel<E> && requires(E const& eos, Pack x) {
  { packed_isochore(eos, x).entropy(x) } -> std::convertible_to<Pack>;
  { packed_isochore(eos, x).pressure_slope(x) } -> std::convertible_to<Pack>;
  { packed_isochore(eos, x).pressure_density_slope(x) } -> std::convertible_to<Pack>;
};

/// A register full of mixtures, solved together by Newton's method from near guesses as Mixture solves one.
/// Lanes that it does not solve (a far guess, no equilibrium, 0 < lambda < 1 violated, a NaN) are false in
/// the mask, and go the careful way of Mixture, which answers or names why not. A lane's results do not
/// depend on what the other lanes hold.
template <PackedPart Reactant, PackedPart Product>
class PackedMixture {
 public:
  template <class E>
  using IsochoreOf = decltype(packed_isochore(std::declval<E const&>(), Pack()));
  using At = MixtureAt<Pack, IsochoreOf<Reactant>, IsochoreOf<Product>>;

  /// Keeps the mixture by reference.
  explicit PackedMixture(Mixture<Reactant, Product> const& mixture) : mixture_(mixture) {}

  /// What the mixture is at a split.
  At at(Pack lambda, Pack rho, PackedSplit const& split) const {
    auto const d = mixture_densities(mixture_.law(), lambda, rho, split.log_density_ratio);
    return {lambda,
            rho,
            split.T,
            d.share,
            {packed_isochore(mixture_.reactant(), d.reactant), d.reactant, split.T},
            {packed_isochore(mixture_.product(), d.product), d.product, split.T}};
  }
  /// The lanes at which both models hold and the parts are stable.
  PackMask covered(At const& at) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return between(at.lambda, 0, 1) & covers(mixture_.reactant(), at.reactant.rho, at.T) &
           covers(mixture_.product(), at.product.rho, at.T) & between(at.reactant.rho_P_rho, 0, infinity) &
           between(at.product.rho_P_rho, 0, infinity);
  }

  /// The split at the given energies or entropies, from that of near states, and the lanes that were solved:
  /// the last step was below 1e-8, which leaves round-off only. `other` is the entropy where the energy was
  /// given, and the energy where the entropy was, to the order of that step's square.
  struct Solution {
    PackedSplit split;
    Pack other;
    PackMask solved;
  };
  Solution from_energy(Pack lambda, Pack rho, Pack e, PackedSplit const& guess) const {
    return newton(
        lambda, rho, guess,
        [&](At const& at) { return at.step(e - at.energy(), at.energy_r(), at.energy_T()); },
        [](At const& at, Pack dT, Pack dr) {
          return at.entropy() + at.entropy_T() * dT + at.entropy_r() * dr;
        });
  }
  Solution from_entropy(Pack lambda, Pack rho, Pack s, PackedSplit const& guess) const {
    return newton(
        lambda, rho, guess,
        [&](At const& at) { return at.step(s - at.entropy(), at.entropy_r(), at.entropy_T()); },
        [](At const& at, Pack dT, Pack dr) { return at.energy() + at.energy_T() * dT + at.energy_r() * dr; });
  }

 private:
  static Pack magnitude(Pack x) { return select(x.v < 0, -x, x); }

  template <class F, class Other>
  Solution newton(Pack lambda, Pack rho, PackedSplit split, F const& towards, Other const& other) const {
    constexpr double last_step = 1e-8, longest_step = 0.5;
    constexpr int most_steps = 12;
    PackMask running = ~PackMask{}, solved{};
    Pack found = 0.0;
    for (int iteration = 0; iteration < most_steps && !all_of(~running); ++iteration) {
      At const here = at(lambda, rho, split);
      running &= covered(here);
      auto const step = towards(here);
      Pack const T_change = magnitude(step.dT) / split.T, r_change = magnitude(step.dr);
      Pack const longest = select(T_change.v > r_change.v, T_change, r_change);
      Pack const fraction = select(longest.v > longest_step, longest_step / longest, 1.0);
      split.T = select(running, split.T + fraction * step.dT, split.T);
      split.log_density_ratio =
          select(running, split.log_density_ratio + fraction * step.dr, split.log_density_ratio);
      auto const arrived = running & (longest.v < last_step);
      if (!all_of(~arrived))
        found = select(arrived, other(here, step.dT, step.dr), found);
      solved |= arrived;
      running &= ~arrived;
    }
    return {split, found, solved};
  }

  Mixture<Reactant, Product> const& mixture_;
};

} // namespace mesobridge::fitting
