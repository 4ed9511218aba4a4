#pragma once
#include "sdpd/fluctuation/pair_lanes.hpp"

namespace mesobridge::sdpd {

/// What the first particle of each pair gains of the scaled relative velocity v, and the second loses, in the
/// explicit step of all pairs at once (sdpd/README.md, Eq. (S25)), -Gamma v dt + Sigma G sqrt(dt), at the
/// velocities and temperatures of the start.
template <class Law, class X>
[[gnu::always_inline]] inline VectorLanes<X> ser_change(Law const& law, Bath<X> const& bath,
                                                        InputLanes<Law::across, X> const& input,
                                                        VectorLanes<X> const& v, double time) {
  X const dt = constant<X>(time);
  auto const [a_par, a_perp] = law.coefficients(input.weight);
  X const gamma_par = a_par * bath.gamma_over_a * dt;
  X const sigma_par = square_root(bath.thermal * gamma_par);
  auto const &e = input.e, &G = input.G;
  if constexpr (Law::across == Transverse::none) {
    X const along = sigma_par * input.G_along - gamma_par * dot(e, v);
    return {along * e.x, along * e.y, along * e.z};
  } else {
    X const gamma_perp = a_perp * bath.gamma_over_a * dt, sigma_perp = square_root(bath.thermal * gamma_perp);
    X const along = (gamma_perp - gamma_par) * dot(e, v) + (sigma_par - sigma_perp) * input.G_along;
    return {sigma_perp * G.x - gamma_perp * v.x + along * e.x,
            sigma_perp * G.y - gamma_perp * v.y + along * e.y,
            sigma_perp * G.z - gamma_perp * v.z + along * e.z};
  }
}

/// The heat of each of a pair's particles, -(1/2) dp_ij (v_ij + dv_ij/2), with dv_ij what all pairs together
/// change v_ij by; `mean` is the bracket. So the energy is conserved exactly, whatever the other pairs do.
template <class Vector>
[[gnu::always_inline]] inline auto ser_heat(Vector const& change, Vector const& mean) {
  return -0.5 * dot(change, mean);
}

/// Gives the heat to particle i, with the temperature that its caloric expansion has there; reports one that
/// is not positive.
inline void gain_of_ser(Particles& particles, std::size_t i, double gain, Failure& failure) {
  particles.eps[i] += gain;
  double const T = particles.caloric[i].T(gain);
  if (!(T > 0))
    failure.report(particles.id[i],
                   fmt::format("fluctuation and dissipation (SER) took its internal energy to {:.6g} (in K "
                               "k_B T), where its temperature is not positive; take a shorter time step",
                               particles.eps[i]));
  particles.T[i] = T;
}

} // namespace mesobridge::sdpd
