#pragma once
#include "sdpd/simd/lane_math.hpp"

namespace mesobridge::sdpd {

/// What one exact Ornstein-Uhlenbeck step over dt does to the relative velocity of a pair in one direction:
/// v' = (1 + decay) v + kick() G, with G a standard Gaussian number (sdpd/README.md, Eq. (S22)). X is a
/// number or lanes of numbers.
template <class X>
struct OrnsteinUhlenbeck {
  X decay;    ///< alpha - 1 = exp(-2 gamma dt / m) - 1
  X variance; ///< zeta^2

  [[gnu::always_inline]] X kick() const { return square_root(variance); }
};

/// Friction and noise of a pair of equal masses m = 1 at one pair of temperatures. For every coefficient a
/// that the pair's places give, friction gamma = gamma_over_a a and noise sigma^2 = thermal gamma come from
/// the same two numbers, so that the fluctuation-dissipation relation, which a pair law fulfils when it makes
/// a bath, cannot be broken afterwards.
template <class X>
struct Bath {
  X gamma_over_a;
  X thermal; ///< sigma^2 / gamma

  /// Both directions, along the pair with friction coefficient a_par and across it with a_perp.
  struct Directions {
    OrnsteinUhlenbeck<X> par, perp;
  };
  [[gnu::always_inline]] Directions step(X const& a_par, X const& a_perp, bool par_is_twice_perp,
                                         double dt) const {
    OrnsteinUhlenbeck<X> const across = step(a_perp, dt);
    if (!par_is_twice_perp)
      return {step(a_par, dt), across};
    return {of_decay(across.decay * (2 + across.decay)), across}; // exp(-2x) - 1 from exp(-x) - 1
  }

  /// One direction with friction coefficient `a` over the time dt.
  [[gnu::always_inline]] OrnsteinUhlenbeck<X> step(X const& a, double dt) const {
    return of_decay(minus_expm1(constant<X>(2 * dt) * a * gamma_over_a));
  }

 private:
  [[gnu::always_inline]] OrnsteinUhlenbeck<X> of_decay(X const& decay) const {
    return {decay, thermal * -decay * (2 + decay)};
  }
};

/// Temperatures and inverse heat capacities of a pair: all that a law may make a bath of.
template <class X>
struct PairTemperatures {
  X T_i, T_j, inverse_C_i, inverse_C_j;
};

/// What the places of a pair give its friction: par along the line of centres, perp across it.
template <class X>
struct PairWeights {
  X par, perp;
};

/// The noise that a pair's step takes.
enum class PairNoise {
  vector, ///< three numbers as a vector that points from the smaller to the larger id
  along,  ///< one along the line of centres
  flow    ///< one of what the smaller id gets from the larger
};

/// The friction across the line of centres.
enum class Transverse {
  none,   ///< there is none
  common, ///< it belongs to the same weight as that along the line
  own     ///< it has a weight of its own
};

} // namespace mesobridge::sdpd
