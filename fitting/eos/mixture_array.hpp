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

/// Many mixtures at once; models without isochores of packs go one by one. Particles that the rule of
/// PureProgress counts as pure get the pure model's answer, and keep their ratio of densities for a later
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

  Mixture<Reactant, Product> const& mixture() const { return mixture_; }

 private:
  enum class Given { energy, entropy };

  template <Given given, class Failed>
  void renew(MixtureStates const& states, std::size_t begin, std::size_t end, Failed const& failed) const {
    for_each_component_pack(states.lambda, begin, end, pure_, [&](Component kind, ScatteredPlaces const& at) {
      auto const solved = kind == Component::mixed      ? mixed<given>(states, at)
                          : kind == Component::reactant ? pure<given>(mixture_.reactant(), states, at)
                                                        : pure<given>(mixture_.product(), states, at);
      at.for_each_outside(solved, [&](std::size_t i) {
        try {
          alone<given>(states, i, kind);
        } catch (PhysicsError const& error) {
          failed(i, error);
        }
      });
    });
  }

  /// Each of these returns the lanes that it solved.
  template <Given given>
  PackMask mixed(MixtureStates const&, ScatteredPlaces const&) const {
    return PackMask{};
  }
  template <Given given>
  PackMask mixed(MixtureStates const& states,
                 ScatteredPlaces const& at) const requires PackedPart<Reactant> && PackedPart<Product> {
    PackedMixture<Reactant, Product> const packed(mixture_);
    Pack const lambda = at.load(states.lambda), rho = at.load(states.rho);
    PackedSplit const guess{at.load(states.T), at.load(states.log_density_ratio)};
    auto const found = given == Given::energy ? packed.from_energy(lambda, rho, at.load(states.e), guess)
                                              : packed.from_entropy(lambda, rho, at.load(states.s), guess);
    auto const here = packed.at(lambda, rho, found.split);
    Pack const C = here.heat_capacity();
    auto const fine = found.solved & packed.covered(here) & between(C, 0, infinity);
    at.store(found.split.T, fine, states.T);
    at.store(found.split.log_density_ratio, fine, states.log_density_ratio);
    if constexpr (given == Given::energy)
      at.store(here.entropy(), fine, states.s);
    else
      at.store(here.energy(), fine, states.e);
    at.store(here.pressure(), fine, states.P);
    at.store(C, fine, states.C);
    at.store(here.sound_speed_squared(), fine, states.sound_speed_squared);
    return fine;
  }

  template <Given given, class E>
  static PackMask pure(E const&, MixtureStates const&, ScatteredPlaces const&) {
    return PackMask{};
  }
  template <Given given, PackedPart E>
  static PackMask pure(E const& eos, MixtureStates const& states, ScatteredPlaces const& at) {
    Pack const rho = at.load(states.rho), guess = at.load(states.T);
    auto const isochore = packed_isochore(eos, rho);
    Pack const T = given == Given::energy ? temperature_from_energy(isochore, at.load(states.e), guess)
                                          : temperature_from_entropy(isochore, at.load(states.s), guess);
    Pack const C = isochore.heat_capacity(T), slope = isochore.pressure_slope(T) / rho;
    auto const fine = covers(eos, rho, T);
    at.store(T, fine, states.T);
    if constexpr (given == Given::energy)
      at.store(isochore.entropy(T), fine, states.s);
    else
      at.store(isochore.energy(T), fine, states.e);
    at.store(isochore.pressure(T), fine, states.P);
    at.store(C, fine, states.C);
    at.store(isochore.pressure_density_slope(T) + T * slope * slope / C, fine, states.sound_speed_squared);
    return fine;
  }

  template <Given given>
  void alone(MixtureStates const& to, std::size_t i, Component kind) const {
    double const lambda = kind == Component::mixed ? to.lambda[i] : kind == Component::product ? 1 : 0;
    MixtureSplit const guess{to.T[i], to.log_density_ratio[i]};
    auto const found = given == Given::energy
                           ? mixture_.state(lambda, to.rho[i], to.e[i], guess)
                           : mixture_.state_from_entropy(lambda, to.rho[i], to.s[i], guess);
    to.T[i] = found.T;
    if (kind == Component::mixed)
      to.log_density_ratio[i] = found.split.log_density_ratio;
    (given == Given::energy ? to.s : to.e)[i] = given == Given::energy ? found.s : found.e;
    to.P[i] = found.P, to.C[i] = found.c_v, to.sound_speed_squared[i] = found.sound_speed_squared;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Mixture<Reactant, Product> mixture_;
  PureProgress pure_;
};

} // namespace mesobridge::fitting
