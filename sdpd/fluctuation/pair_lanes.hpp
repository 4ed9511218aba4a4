#pragma once
#include "sdpd/fluctuation/fluctuating_block.hpp"

/// The Ornstein-Uhlenbeck steps of pairs that share no particle, eight or sixteen at once.
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

/// The same of particles with one constant heat capacity, counted from T = 0.
struct ConstantCaloric {
  double C, inverse;

  [[gnu::always_inline]] Lanes T(Lanes const& u) const { return u * inverse; }
  [[gnu::always_inline]] Lanes inverse_C(Lanes const&) const { return broadcast(inverse); }
  [[gnu::always_inline]] static unsigned in_reach(Lanes const&) { return (1u << lane_count) - 1; }
};

/// What pairs' temperatures become, T to T_1, does to the sums of their entropies and of ln T.
struct PairChange {
  Lanes entropy, log_T;
};
[[gnu::always_inline]] inline PairChange pair_change(CaloricLanes const& a, CaloricLanes const& b,
                                                     Lanes const& T_a, Lanes const& T_b, Lanes const& T_a1,
                                                     Lanes const& T_b1) {
  Lanes const log_a = logarithm(T_a1 / T_a), log_b = logarithm(T_b1 / T_b);
  return {a.entropy_change(T_a, T_a1, log_a) + b.entropy_change(T_b, T_b1, log_b), log_a + log_b};
}
/// With one heat capacity, one logarithm says both.
[[gnu::always_inline]] inline PairChange pair_change(ConstantCaloric const& of_both, ConstantCaloric const&,
                                                     Lanes const& T_a, Lanes const& T_b, Lanes const& T_a1,
                                                     Lanes const& T_b1) {
  Lanes const log_T = logarithm((T_a1 * T_b1) / (T_a * T_b));
  return {of_both.C * log_T, log_T};
}

/// Eight particles, one of each pair.
struct ConstantCapacityLanes {
  Lanes p_x, p_y, p_z, u;
  ConstantCaloric caloric;
};
struct ParticleLanes {
  Lanes p_x, p_y, p_z, u;
  CaloricLanes caloric;

  [[gnu::always_inline]] explicit ParticleLanes(LineLanes const& line)
      : p_x(line[0]), p_y(line[1]), p_z(line[2]), u(line[3]), caloric{line[4], line[5], line[6], line[7]} {}
};

/// Vectors of the pairs.
template <class X>
struct VectorLanes {
  X x, y, z;

  [[gnu::always_inline]] friend X dot(VectorLanes const& a, VectorLanes const& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
};

/// Geometry and noise of as many pairs as there are Floats.
template <Transverse across, class Floats>
struct InputLanes {
  PairWeights<Floats> weight;
  VectorLanes<Floats> e, G;
  Floats G_along; ///< e . G

  [[gnu::always_inline]] InputLanes(PairInputs const& from, std::size_t first)
      : e{load<Floats>(&from.e_x[first]), load<Floats>(&from.e_y[first]), load<Floats>(&from.e_z[first])} {
    Floats const x = load<Floats>(&from.G_x[first]);
    if constexpr (across == Transverse::none) {
      G_along = x;
      G = {x * e.x, x * e.y, x * e.z};
    } else {
      G = {x, load<Floats>(&from.G_y[first]), load<Floats>(&from.G_z[first])};
      G_along = dot(e, G);
    }
    weight.par = weight.perp = load<Floats>(&from.weight[first]);
    if constexpr (across == Transverse::own)
      weight.perp = load<Floats>(&from.weight_across[first]);
  }

  /// Of noise as a vector, whose first component alone counts where all friction is along e.
  [[gnu::always_inline]] InputLanes(PairWeights<Floats> const& weights, VectorLanes<Floats> const& direction,
                                    VectorLanes<Floats> const& noise)
      : weight(weights), e(direction), G(noise),
        G_along(across == Transverse::none ? noise.x : dot(direction, noise)) {}
};

/// The Ornstein-Uhlenbeck steps of pairs in their baths.
template <class Law, class Floats>
[[gnu::always_inline]] inline typename Bath<Floats>::Directions
step_in(Bath<Floats> const& bath, Law const& law, PairWeights<Floats> const& weight, double dt) {
  auto const [a_par, a_perp] = law.coefficients(weight);
  if constexpr (Law::across == Transverse::none)
    return {bath.step(a_par, dt), {Floats{}, Floats{}}};
  else
    return bath.step(a_par, a_perp, law.par_is_twice_perp(), dt);
}

/// The change of the relative velocity v.
template <Transverse across, class Floats>
[[gnu::always_inline]] inline VectorLanes<Floats>
velocity_change(typename Bath<Floats>::Directions const& step, InputLanes<across, Floats> const& input,
                VectorLanes<Floats> const& v) {
  auto const& [par, perp] = step;
  auto const &e = input.e, &G = input.G;
  if constexpr (across == Transverse::none) {
    Floats const along = par.decay * dot(e, v) + par.kick() * input.G_along;
    return {along * e.x, along * e.y, along * e.z};
  } else {
    Floats const kick = perp.kick();
    Floats const along = (par.decay - perp.decay) * dot(e, v) + (par.kick() - kick) * input.G_along;
    return {perp.decay * v.x + kick * G.x + along * e.x, perp.decay * v.y + kick * G.y + along * e.y,
            perp.decay * v.z + kick * G.z + along * e.z};
  }
}

} // namespace mesobridge::sdpd
