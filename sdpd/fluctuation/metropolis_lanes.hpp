#pragma once
#include "sdpd/fluctuation/pair_lanes.hpp"

/// The noise's part in the exponent of EMS, for pairs in lanes (sdpd/README.md, Eq. (S24)).
namespace mesobridge::sdpd {

/// a/b where b > 0, and 1 where both vanish (at the edge of the kernel, where nothing happens).
template <class Floats>
[[gnu::always_inline]] inline Floats ratio(Floats const& a, Floats const& b) {
  constexpr float tiny = 1e-37f;
  return (a + tiny) / (b + tiny);
}

/// The square of the noise that would lead back; that of the noise itself where there is no friction.
template <class Floats>
[[gnu::always_inline]] inline Floats square_over_variance(Floats const& square, Floats const& variance,
                                                          Floats const& noise2) {
  return variance > 0.0f ? square / variance : noise2;
}

/// The noise's part of the exponent a of sdpd/README.md, Eq. (S24), as in ExactPair: G^2 less the square
/// of the noise that would lead back, and the widths' ratio |B|^2/|B'|^2.
template <class Floats>
struct NoiseTerms {
  Floats squares, widths;
};
/// Variances of the step that was proposed, along and across.
template <class Floats>
struct Variances {
  Floats par, perp;
};
template <class Floats>
[[gnu::always_inline]] inline NoiseTerms<Floats>
noise_terms(Variances<Floats> const& there, typename Bath<Floats>::Directions const& back,
            InputLanes<Transverse::common, Floats> const& input, VectorLanes<Floats> const& v,
            VectorLanes<Floats> const& dv) {
  auto const& e = input.e;
  VectorLanes<Floats> const moved{v.x + dv.x, v.y + dv.y, v.z + dv.z};
  VectorLanes<Floats> const rest{dv.x + back.perp.decay * moved.x, dv.y + back.perp.decay * moved.y,
                                 dv.z + back.perp.decay * moved.z};
  Floats const along = dot(e, dv) + back.par.decay * dot(e, moved), rest_along = dot(e, rest);
  Floats const across2 = dot(rest, rest) - rest_along * rest_along;
  Floats const noise2 =
      dot(input.G, input.G) - ratio(along * along, back.par.variance) - ratio(across2, back.perp.variance);
  Floats const across_ratio = ratio(there.perp, back.perp.variance);
  return {noise2, ratio(there.par, back.par.variance) * across_ratio * across_ratio};
}
template <class Floats>
[[gnu::always_inline]] inline NoiseTerms<Floats>
noise_terms(Variances<Floats> const& there, typename Bath<Floats>::Directions const& back,
            InputLanes<Transverse::none, Floats> const& input, VectorLanes<Floats> const& v,
            VectorLanes<Floats> const& dv) {
  Floats const along_dv = dot(input.e, dv), noise = input.G_along, noise2 = noise * noise;
  Floats const along = along_dv + back.par.decay * (dot(input.e, v) + along_dv);
  return {noise2 - square_over_variance(along * along, back.par.variance, noise2),
          ratio(there.par, back.par.variance)};
}
/// Either friction may vanish alone, which must not leave a round-off of the other.
template <class Floats>
[[gnu::always_inline]] inline NoiseTerms<Floats>
noise_terms(Variances<Floats> const& there, typename Bath<Floats>::Directions const& back,
            InputLanes<Transverse::own, Floats> const& input, VectorLanes<Floats> const& v,
            VectorLanes<Floats> const& dv) {
  auto const &e = input.e, &G = input.G;
  VectorLanes<Floats> const moved{v.x + dv.x, v.y + dv.y, v.z + dv.z};
  Floats const along_dv = dot(e, dv), along_moved = dot(e, moved), noise = input.G_along;
  Floats const along = along_dv + back.par.decay * along_moved;
  auto across = [&](Floats const& dv_k, Floats const& moved_k, Floats const& e_k) {
    return dv_k - along_dv * e_k + back.perp.decay * (moved_k - along_moved * e_k);
  };
  VectorLanes<Floats> const side{across(dv.x, moved.x, e.x), across(dv.y, moved.y, e.y),
                                 across(dv.z, moved.z, e.z)};
  Floats const noise2 = noise * noise, noise_across2 = dot(G, G) - noise2;
  Floats const across_ratio = ratio(there.perp, back.perp.variance);
  return {noise2 - square_over_variance(along * along, back.par.variance, noise2) + noise_across2 -
              square_over_variance(dot(side, side), back.perp.variance, noise_across2),
          ratio(there.par, back.par.variance) * across_ratio * across_ratio};
}

} // namespace mesobridge::sdpd
