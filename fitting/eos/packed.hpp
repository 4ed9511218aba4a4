#pragma once
#include "fitting/eos/linear_isochore.hpp"
#include "fitting/eos/monotone_root.hpp"
#include "fitting/simd/pack.hpp"

/// Isochores of a register full of densities. They do not look at their arguments: covers(eos, rho, T) tells
/// the lanes that mean something, and the others go the careful way of one state at a time. A lane's results
/// do not depend on what the other lanes hold.
namespace mesobridge::fitting {

template <LinearModel E>
BasicLinearIsochore<Pack> packed_isochore(E const& eos, Pack rho) {
  return {std::string_view(), rho, eos.c_v(), eos.law(rho)};
}
template <LinearModel E>
PackMask covers(E const& eos, Pack rho, Pack T) {
  return between(rho, 0, eos.rho_max()) & between(T, 0, std::numeric_limits<double>::infinity());
}

template <class E>
requires(!LinearModel<E>) auto packed_isochore(E const& eos, Pack rho) -> decltype(eos.packed_isochore(rho)) {
  return eos.packed_isochore(rho);
}
template <class E>
requires(!LinearModel<E>) PackMask covers(E const& eos, Pack rho, Pack T) {
  return eos.covers(rho, T);
}

/// A model with such isochores.
template <class E>
concept PackedModel = requires(E const& eos, Pack rho) {
  packed_isochore(eos, rho);
};

namespace pack {

/// As solve_increasing from a near guess: Halley's steps until one is below 1e-6 x, which leaves round-off
/// only. NaN where six do not suffice.
template <class F>
Pack root(F const& jet, Pack target, Pack guess) {
  constexpr double small = 1e-6;
  constexpr int most_steps = 6;
  Pack x = guess;
  PackMask done{};
  for (int iteration = 0; iteration < most_steps && !all_of(done); ++iteration) {
    auto const [value, slope, curvature] = jet(x);
    Pack const newton = (target - value) / slope, step = newton / (1.0 + 0.5 * newton * curvature / slope);
    x = select(done, x, x + step);
    done |= (step.v <= small * x.v) & (-step.v <= small * x.v);
  }
  return select(done, x, std::numeric_limits<double>::quiet_NaN());
}

struct Jet {
  Pack value, slope, curvature;
};

} // namespace pack

/// Temperatures of single states, as the isochores give them themselves.
template <class Isochore>
double temperature_from_energy(Isochore const& at, double e, double T_guess) {
  return at.temperature_from_energy(e, T_guess);
}
template <class Isochore>
double temperature_from_entropy(Isochore const& at, double s, double T_guess) {
  return at.temperature_from_entropy(s, T_guess);
}
/// Temperatures of packs from energies or entropies; NaN, or a number that covers() refuses, where there is
/// none or the guess was far.
inline Pack temperature_from_energy(BasicLinearIsochore<Pack> const& at, Pack e, Pack /*T_guess*/) {
  return at.unchecked_temperature_from_energy(e);
}
inline Pack temperature_from_entropy(BasicLinearIsochore<Pack> const& at, Pack s, Pack /*T_guess*/) {
  return at.unchecked_temperature_from_entropy(s);
}
template <class Isochore>
Pack temperature_from_energy(Isochore const& at, Pack e, Pack T_guess) {
  return pack::root(
      [&](Pack T) {
        return pack::Jet{at.energy(T), at.heat_capacity(T), at.heat_capacity_slope(T)};
      },
      e, T_guess);
}
template <class Isochore>
Pack temperature_from_entropy(Isochore const& at, Pack s, Pack T_guess) {
  return pack::root(
      [&](Pack T) {
        Pack const slope = at.heat_capacity(T) / T;
        return pack::Jet{at.entropy(T), slope, (at.heat_capacity_slope(T) - slope) / T};
      },
      s, T_guess);
}

} // namespace mesobridge::fitting
