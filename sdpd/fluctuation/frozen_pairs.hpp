#pragma once
#include "sdpd/fluctuation/pair_lanes.hpp"
#include "sdpd/fluctuation/scaled_velocity.hpp"

namespace mesobridge::sdpd {

/// Direction, friction times dt and noise of a block's pairs, frozen at the start of the step.
struct FrozenPairs {
  std::vector<float> e_x, e_y, e_z, perp, extra, n_x, n_y, n_z;

  void resize(std::size_t count) {
    for (auto* values : {&e_x, &e_y, &e_z, &perp, &extra, &n_x, &n_y, &n_z})
      values->resize(count);
  }
  /// From those of scaled velocities to those of the pairs' masses.
  void scale(std::size_t k, PairMasses<double> const& mass) {
    auto const m = static_cast<float>(mass.reduced()), root = std::sqrt(m);
    perp[k] *= m, extra[k] *= m, n_x[k] *= root, n_y[k] *= root, n_z[k] *= root;
  }
  void take_back(std::size_t k) { perp[k] = extra[k] = n_x[k] = n_y[k] = n_z[k] = 0; }
};

using Impulse = VectorLanes<FloatLanes>;

[[gnu::always_inline]] inline Impulse noise(FrozenPairs const& of, std::size_t first) {
  return {load<FloatLanes>(&of.n_x[first]), load<FloatLanes>(&of.n_y[first]),
          load<FloatLanes>(&of.n_z[first])};
}

/// -Gamma v dt, along the line of centres and across it.
[[gnu::always_inline]] inline Impulse friction(FrozenPairs const& of, std::size_t first, Impulse const& v) {
  Impulse const e{load<FloatLanes>(&of.e_x[first]), load<FloatLanes>(&of.e_y[first]),
                  load<FloatLanes>(&of.e_z[first])};
  FloatLanes const perp = load<FloatLanes>(&of.perp[first]),
                   along = load<FloatLanes>(&of.extra[first]) * dot(e, v);
  return {-perp * v.x - along * e.x, -perp * v.y - along * e.y, -perp * v.z - along * e.z};
}

[[gnu::always_inline]] inline Impulse operator+(Impulse const& a, Impulse const& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

} // namespace mesobridge::sdpd
