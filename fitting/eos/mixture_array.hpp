#pragma once
#include "fitting/eos/array.hpp"
#include "fitting/eos/mixture_packed.hpp"
#include <array>
#include <vector>

namespace mesobridge::fitting {

/// States of mixtures in arrays of equal length; which of them are read and written depends on the function.
struct MixtureStates {
  std::span<double const> lambda, rho;
  std::span<double> e, s;
  /// What a solution starts from and leaves for the next one: of nearby states, or any T > 0 and 0.
  std::span<double> T, log_density_ratio;
  std::span<double> P, C, sound_speed_squared;
};

/// Places anywhere in arrays that fill a pack; the last one fills the lanes left over.
class ScatteredPlaces {
 public:
  bool full() const { return count_ == Pack::size; }
  bool empty() const { return count_ == 0; }
  void push(std::size_t place) { place_[static_cast<std::size_t>(count_++)] = place; }
  void clear() { count_ = 0; }

  Pack load(std::span<double const> from) const {
    Pack some;
    for (int lane = 0; lane < Pack::size; ++lane)
      some.v[lane] = from[at(lane)];
    return some;
  }
  /// Writes the lanes of the mask.
  void store(Pack values, PackMask where, std::span<double> to) const {
    for (int lane = 0; lane < count_; ++lane)
      if (where[lane])
        to[at(lane)] = values.v[lane];
  }
  /// Calls f(place) for the lanes outside the mask.
  template <class F>
  void for_each_outside(PackMask mask, F const& f) const {
    for (int lane = 0; lane < count_; ++lane)
      if (!mask[lane])
        f(at(lane));
  }

 private:
  std::size_t at(int lane) const { return place_[static_cast<std::size_t>(std::min(lane, count_ - 1))]; }
  std::array<std::size_t, Pack::size> place_{};
  int count_ = 0;
};

/// Calls f(component, places) for all places of the range, by packs of one component each: lanes of pure
/// particles do not wait for mixtures.
template <class F>
void for_each_component_pack(std::span<double const> lambda, std::size_t begin, std::size_t end,
                             PureProgress const& pure, F&& f) {
  std::array<ScatteredPlaces, 3> packs;
  for (std::size_t i = begin; i < end; ++i) {
    auto const kind = component(lambda[i], pure);
    auto& pack = packs[static_cast<std::size_t>(kind)];
    pack.push(i);
    if (pack.full()) {
      f(kind, pack);
      pack.clear();
    }
  }
  for (auto const kind : {Component::reactant, Component::product, Component::mixed})
    if (auto const& pack = packs[static_cast<std::size_t>(kind)]; !pack.empty())
      f(kind, pack);
}

/// Many mixtures at once. The engine solves its mixtures one by one, as yet; this is timed
/// by `bench eos --model mixture`. Models without isochores of packs go one by one. Particles that the rule
/// of PureProgress counts as pure get the pure model's answer, and keep their ratio of densities for a later
/// start.
template <EquationOfState Reactant, EquationOfState Product>
class MixtureArray {
 public:
  explicit MixtureArray(Mixture<Reactant, Product> mixture, PureProgress pure = {})
      : mixture_(std::move(mixture)), pure_(pure) {}

  /// s, T, P, C, c^2 from e, rho and lambda of the places begin ... end-1. A state that has no equilibrium is
  /// given to failed(place, error); the others go on.
  template <class Failed>
  void from_energy(MixtureStates const& states, std::size_t begin, std::size_t end,
                   Failed const& failed) const {
    renew<Given::energy>(states, begin, end, failed);
  }
  /// e, T, P, C, c^2 from s, rho and lambda.
  template <class Failed>
  void from_entropy(MixtureStates const& states, std::size_t begin, std::size_t end,
                    Failed const& failed) const {
    renew<Given::entropy>(states, begin, end, failed);
  }
  /// P, C, c^2 from rho, lambda and what a solution left, T and the ratio of densities: the very bits that
  /// the solution gave, e and s untouched.
  template <class Failed>
  void response(MixtureStates const& states, std::size_t begin, std::size_t end, Failed const& failed) const {
    renew<Given::split>(states, begin, end, failed);
  }
  /// Everything from T, rho and lambda, by a search; for the beginning.
  template <class Failed>
  void from_temperature(MixtureStates const& states, std::size_t begin, std::size_t end,
                        Failed const& failed) const {
    for (std::size_t i = begin; i < end; ++i)
      reported(i, failed, [&] {
        auto const found = mixture_.state_from_temperature(progress(states, i), states.rho[i], states.T[i]);
        states.log_density_ratio[i] = found.split.log_density_ratio;
        states.e[i] = found.e, states.s[i] = found.s;
        respond_one<Given::split>(states, i);
      });
  }

  Mixture<Reactant, Product> const& mixture() const { return mixture_; }

 private:
  enum class Given { energy, entropy, split };
  static constexpr bool packed_mixture = PackedPart<Reactant> && PackedPart<Product>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// The progress by the rule of pure components.
  double progress(MixtureStates const& states, std::size_t i) const {
    auto const kind = component(states.lambda[i], pure_);
    return kind == Component::mixed ? states.lambda[i] : kind == Component::product ? 1 : 0;
  }
  template <class Failed, class F>
  static void reported(std::size_t i, Failed const& failed, F const& f) {
    try {
      f();
    } catch (PhysicsError const& error) {
      failed(i, error);
    }
  }

  template <Given given, class Failed>
  void renew(MixtureStates const& states, std::size_t begin, std::size_t end, Failed const& failed) const {
    for_each_component_pack(states.lambda, begin, end, pure_, [&](Component kind, ScatteredPlaces const& at) {
      auto const solved = solve<given>(kind, states, at);
      auto const fine = respond<given>(kind, states, at, solved);
      at.for_each_outside(fine, [&](std::size_t i) {
        reported(i, failed, [&] {
          solve_alone<given>(states, i);
          respond_one<given>(states, i);
        });
      });
    });
  }

  /// T and the ratio of densities; returns the lanes that it solved.
  template <Given given>
  PackMask solve(Component kind, MixtureStates const& states, ScatteredPlaces const& at) const {
    if constexpr (given == Given::split)
      return ~PackMask{};
    else if (kind == Component::mixed)
      return solve_mixed<given>(states, at);
    else
      return kind == Component::reactant ? solve_pure<given>(mixture_.reactant(), states, at)
                                         : solve_pure<given>(mixture_.product(), states, at);
  }
  template <Given given>
  PackMask solve_mixed(MixtureStates const& states, ScatteredPlaces const& at) const {
    if constexpr (packed_mixture) {
      PackedMixture<Reactant, Product> const packed(mixture_);
      Pack const lambda = at.load(states.lambda), rho = at.load(states.rho);
      PackedSplit const guess{at.load(states.T), at.load(states.log_density_ratio)};
      auto const found = given == Given::energy ? packed.from_energy(lambda, rho, at.load(states.e), guess)
                                                : packed.from_entropy(lambda, rho, at.load(states.s), guess);
      at.store(found.split.T, found.solved, states.T);
      at.store(found.split.log_density_ratio, found.solved, states.log_density_ratio);
      return found.solved;
    } else {
      return PackMask{};
    }
  }
  template <Given given, class E>
  static PackMask solve_pure(E const& eos, MixtureStates const& states, ScatteredPlaces const& at) {
    if constexpr (PackedPart<E>) {
      Pack const rho = at.load(states.rho), guess = at.load(states.T);
      auto const isochore = packed_isochore(eos, rho);
      Pack const T = given == Given::energy ? temperature_from_energy(isochore, at.load(states.e), guess)
                                            : temperature_from_entropy(isochore, at.load(states.s), guess);
      auto const fine = covers(eos, rho, T);
      at.store(T, fine, states.T);
      return fine;
    } else {
      return PackMask{};
    }
  }
  template <Given given>
  void solve_alone(MixtureStates const& to, std::size_t i) const {
    if constexpr (given != Given::split) {
      double const lambda = progress(to, i);
      MixtureSplit const guess{to.T[i], to.log_density_ratio[i]};
      auto const found = given == Given::energy
                             ? mixture_.state(lambda, to.rho[i], to.e[i], guess)
                             : mixture_.state_from_entropy(lambda, to.rho[i], to.s[i], guess);
      to.T[i] = found.T;
      if (lambda > 0 && lambda < 1)
        to.log_density_ratio[i] = found.split.log_density_ratio;
    }
  }

  /// What follows from T and the ratio, for the lanes of the mask that the models cover; returns those.
  template <Given given>
  PackMask respond(Component kind, MixtureStates const& states, ScatteredPlaces const& at,
                   PackMask where) const {
    bool const writes_e = given == Given::entropy, writes_s = given == Given::energy;
    if (kind == Component::mixed)
      return respond_mixed(states, at, where, writes_e, writes_s);
    return kind == Component::reactant
               ? respond_pure(mixture_.reactant(), states, at, where, writes_e, writes_s)
               : respond_pure(mixture_.product(), states, at, where, writes_e, writes_s);
  }
  /// Not inlined, all three: a restart must find the bits of the stopped run, and only the same machine code
  /// rounds alike.
  [[gnu::noinline]] PackMask respond_mixed(MixtureStates const& states, ScatteredPlaces const& at,
                                           PackMask where, bool writes_e, bool writes_s) const {
    if constexpr (packed_mixture) {
      PackedMixture<Reactant, Product> const packed(mixture_);
      auto const here = packed.at(at.load(states.lambda), at.load(states.rho),
                                  {at.load(states.T), at.load(states.log_density_ratio)});
      Pack const C = here.heat_capacity();
      auto const fine = where & packed.covered(here) & between(C, 0, infinity);
      if (writes_e)
        at.store(here.energy(), fine, states.e);
      if (writes_s)
        at.store(here.entropy(), fine, states.s);
      at.store(here.pressure(), fine, states.P);
      at.store(C, fine, states.C);
      at.store(here.sound_speed_squared(), fine, states.sound_speed_squared);
      return fine;
    } else {
      return PackMask{};
    }
  }
  template <class E>
  [[gnu::noinline]] static PackMask respond_pure(E const& eos, MixtureStates const& states,
                                                 ScatteredPlaces const& at, PackMask where, bool writes_e,
                                                 bool writes_s) {
    if constexpr (PackedPart<E>) {
      Pack const rho = at.load(states.rho), T = at.load(states.T);
      auto const isochore = packed_isochore(eos, rho);
      Pack const C = isochore.heat_capacity(T), slope = isochore.pressure_slope(T) / rho;
      auto const fine = where & covers(eos, rho, T);
      if (writes_e)
        at.store(isochore.energy(T), fine, states.e);
      if (writes_s)
        at.store(isochore.entropy(T), fine, states.s);
      at.store(isochore.pressure(T), fine, states.P);
      at.store(C, fine, states.C);
      at.store(isochore.pressure_density_slope(T) + T * slope * slope / C, fine, states.sound_speed_squared);
      return fine;
    } else {
      return PackMask{};
    }
  }
  [[gnu::noinline]] void respond_alone(MixtureStates const& to, std::size_t i, bool writes_e,
                                       bool writes_s) const {
    auto const found = mixture_.state_at(progress(to, i), to.rho[i], {to.T[i], to.log_density_ratio[i]});
    if (writes_e)
      to.e[i] = found.e;
    if (writes_s)
      to.s[i] = found.s;
    to.P[i] = found.P, to.C[i] = found.c_v, to.sound_speed_squared[i] = found.sound_speed_squared;
  }
  /// As one of a pack where that goes, so that it does not matter how T was found.
  template <Given given>
  void respond_one(MixtureStates const& states, std::size_t i) const {
    ScatteredPlaces one;
    one.push(i);
    auto const kind = component(states.lambda[i], pure_);
    if (!respond<given>(kind, states, one, ~PackMask{})[0])
      respond_alone(states, i, given == Given::entropy, given == Given::energy);
  }

  Mixture<Reactant, Product> mixture_;
  PureProgress pure_;
};

} // namespace mesobridge::fitting
