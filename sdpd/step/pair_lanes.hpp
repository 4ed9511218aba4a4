#pragma once
#include "sdpd/step/fluctuating_block.hpp"

/// The Ornstein-Uhlenbeck steps of eight pairs that share no particle.
namespace mesobridge::sdpd {

/// A caloric expansion in lanes.
struct CaloricLanes {
  Lanes T_0, inverse_C_0, curvature, limit;

  [[gnu::always_inline]] Lanes T(Lanes const& u) const { return T_0 + u * (inverse_C_0 + curvature * u); }
  [[gnu::always_inline]] Lanes inverse_C(Lanes const& u) const { return inverse_C_0 + 2.0 * curvature * u; }
  /// Lanes whose expansion serves at this temperature.
  [[gnu::always_inline]] unsigned in_reach(Lanes const& T) const {
    Lanes const change = T - T_0;
    return less(change < 0.0 ? -change : change, limit);
  }
  /// S(T_1) - S(T): with C = C_0 + C' (T - T_0), C' = -2 curvature C_0^3, the integral of C/T.
  [[gnu::always_inline]] Lanes entropy_change(Lanes const& T, Lanes const& T_1,
                                              Lanes const& log_ratio) const {
    Lanes const C_0 = 1.0 / inverse_C_0, slope = -2.0 * curvature * C_0 * C_0 * C_0;
    return (C_0 - slope * T_0) * log_ratio + slope * (T_1 - T);
  }
};

/// Eight particles, one of each pair.
struct ParticleLanes {
  Lanes p_x, p_y, p_z, u;
  CaloricLanes caloric;

  [[gnu::always_inline]] explicit ParticleLanes(LineLanes const& line)
      : p_x(line[0]), p_y(line[1]), p_z(line[2]), u(line[3]), caloric{line[4], line[5], line[6], line[7]} {}
};

/// Vectors of eight pairs.
template <class X>
struct VectorLanes {
  X x, y, z;

  [[gnu::always_inline]] friend X dot(VectorLanes const& a, VectorLanes const& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
};

/// Geometry and noise of eight pairs.
template <Across across>
struct InputLanes {
  PairWeights<FloatLanes> weight;
  VectorLanes<FloatLanes> e, G;

  [[gnu::always_inline]] InputLanes(PairInputs const& from, std::size_t first)
      : e{load<FloatLanes>(&from.e_x[first]), load<FloatLanes>(&from.e_y[first]),
          load<FloatLanes>(&from.e_z[first])},
        G{load<FloatLanes>(&from.G_x[first]), load<FloatLanes>(&from.G_y[first]),
          load<FloatLanes>(&from.G_z[first])} {
    weight.par = weight.perp = load<FloatLanes>(&from.weight[first]);
    if constexpr (across == Across::own)
      weight.perp = load<FloatLanes>(&from.weight_across[first]);
  }
};

using BathLanes = Bath<FloatLanes>;

/// The Ornstein-Uhlenbeck steps of eight pairs in a bath.
template <class Law>
[[gnu::always_inline]] inline BathLanes::Directions
step_in(BathLanes const& bath, Law const& law, PairWeights<FloatLanes> const& weight, double dt) {
  auto const [a_par, a_perp] = law.coefficients(weight);
  if constexpr (Law::across == Across::none)
    return {bath.step(a_par, dt), {FloatLanes{}, FloatLanes{}}};
  else
    return bath.step(a_par, a_perp, law.par_is_twice_perp(), dt);
}

/// The change of the relative velocity v.
template <Across across>
[[gnu::always_inline]] inline VectorLanes<FloatLanes> velocity_change(BathLanes::Directions const& step,
                                                                      InputLanes<across> const& input,
                                                                      VectorLanes<FloatLanes> const& v) {
  auto const& [par, perp] = step;
  auto const &e = input.e, &G = input.G;
  if constexpr (across == Across::none) {
    FloatLanes const along = par.decay * dot(e, v) + par.kick() * dot(e, G);
    return {along * e.x, along * e.y, along * e.z};
  } else {
    FloatLanes const kick = perp.kick();
    FloatLanes const along = (par.decay - perp.decay) * dot(e, v) + (par.kick() - kick) * dot(e, G);
    return {perp.decay * v.x + kick * G.x + along * e.x, perp.decay * v.y + kick * G.y + along * e.y,
            perp.decay * v.z + kick * G.z + along * e.z};
  }
}

} // namespace mesobridge::sdpd
