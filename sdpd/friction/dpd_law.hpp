#pragma once
#include "sdpd/friction/friction_shape.hpp"

namespace mesobridge::sdpd {

/// The pair law of DPDE (sdpd/README.md, Eq. (S13)): sigma^2 = 2 k_B T_0 a at all temperatures, and
/// gamma = (sigma^2/4k_B)(1/T_i + 1/T_j), so that gamma = a at T_i = T_j = T_0. The weight is a, the friction
/// coefficient at T_0 (T_0 = 1, the unit of temperature). The invariant measure is exp(S/k_B) for each
/// particle.
template <Transverse across_>
struct DpdeLaw {
  static constexpr bool has_energies = true, measure_over_T = false;
  static constexpr Transverse across = across_;
  static constexpr PairNoise noise = across == Transverse::none ? PairNoise::along : PairNoise::vector;

  AnyWeightFunction shape;
  double boltzmann;

  template <class X>
  [[gnu::always_inline]] Bath<X> bath(PairTemperatures<X> const& at) const {
    X const product = at.T_i * at.T_j, sum = at.T_i + at.T_j, inverse = 1.0f / (product * sum);
    return {.gamma_over_a = constant<X>(0.5) * (sum * sum * inverse),
            .thermal = constant<X>(4 * boltzmann) * (product * product * inverse)};
  }
  template <class X>
  [[gnu::always_inline]] PairWeights<X> coefficients(PairWeights<X> const& weight) const {
    return weight;
  }
  static constexpr bool par_is_twice_perp() { return false; }
};

/// The pair law of DPD (Eq. (S12)): gamma = sigma^2/(2 k_B T) at the set temperature T = 1; internal energies
/// are not followed.
template <Transverse across_>
struct DpdLaw {
  static constexpr bool has_energies = false, measure_over_T = false;
  static constexpr Transverse across = across_;
  static constexpr PairNoise noise = across == Transverse::none ? PairNoise::along : PairNoise::vector;

  AnyWeightFunction shape;
  double boltzmann;

  template <class X>
  [[gnu::always_inline]] Bath<X> bath() const {
    return {.gamma_over_a = constant<X>(1), .thermal = constant<X>(2 * boltzmann)};
  }
  template <class X>
  [[gnu::always_inline]] PairWeights<X> coefficients(PairWeights<X> const& weight) const {
    return weight;
  }
  static constexpr bool par_is_twice_perp() { return false; }
};

} // namespace mesobridge::sdpd
