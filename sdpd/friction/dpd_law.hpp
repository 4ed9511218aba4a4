#pragma once
#include "sdpd/friction/friction_shape.hpp"

namespace mesobridge::sdpd {

/// What the laws of DPD and DPDE have in common: the weight is the friction coefficient a.
template <Transverse across_>
struct PairFluidLaw {
  static constexpr Transverse across = across_;
  static constexpr PairNoise noise = across == Transverse::none ? PairNoise::along : PairNoise::vector;

  AnyWeightFunction shape;
  double boltzmann;

  template <class X>
  [[gnu::always_inline]] PairWeights<X> coefficients(PairWeights<X> const& weight) const {
    return weight;
  }
  static constexpr bool par_is_twice_perp() { return false; }
};

/// The pair law of DPDE (sdpd/README.md, Eq. (S13)): sigma^2 = 2 k_B T_0 a at all temperatures, and
/// gamma = (sigma^2/4k_B)(1/T_i + 1/T_j), so that gamma = a at T_i = T_j = T_0. The weight is a, the friction
/// coefficient at T_0 (T_0 = 1, the unit of temperature). The invariant measure is exp(S/k_B) for each
/// particle.
template <Transverse across_>
struct DpdeLaw : PairFluidLaw<across_> {
  static constexpr bool has_energies = true, measure_over_T = false;

  template <class X>
  [[gnu::always_inline]] Bath<X> bath(PairTemperatures<X> const& at) const {
    X const product = at.T_i * at.T_j, sum = at.T_i + at.T_j, inverse = 1.0f / (product * sum);
    return {.gamma_over_a = constant<X>(0.5) * (sum * sum * inverse),
            .thermal = constant<X>(4 * this->boltzmann) * (product * product * inverse)};
  }
};

/// The pair law of DPD (Eq. (S12)): gamma = sigma^2/(2 k_B T) at the set temperature T = 1; internal energies
/// are not followed.
template <Transverse across_>
struct DpdLaw : PairFluidLaw<across_> {
  static constexpr bool has_energies = false, measure_over_T = false;

  template <class X>
  [[gnu::always_inline]] Bath<X> bath() const {
    return {.gamma_over_a = constant<X>(1), .thermal = constant<X>(2 * this->boltzmann)};
  }
};

} // namespace mesobridge::sdpd
