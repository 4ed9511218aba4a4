#pragma once
#include "sdpd/fluctuation/pair_lanes.hpp"
#include "sdpd/lammps/rank_particles.hpp"
#include "sdpd/state/random_lanes.hpp"

namespace mesobridge::sdpd {

/// The noise of sixteen pairs, vectors that point from the smaller id to the larger one.
struct PairNoiseLanes {
  WideFloats x, y, z;
  WideBits bits; ///< spare ones, for a Metropolis test

  PairNoiseLanes(NoiseLanes const& source, RankParticles const& particles, std::uint32_t const* i,
                 std::uint32_t const* j, PairNoise kind) {
    auto const* const ids = reinterpret_cast<std::uint32_t const*>(particles.ids);
    WideBits const a = gather(ids, load<WideBits>(i)) - 1u, b = gather(ids, load<WideBits>(j)) - 1u;
    GaussianLanes const G(source, a < b ? a : b, a < b ? b : a);
    auto const plus = constant<WideFloats>(1);
    WideFloats const sign = kind == PairNoise::along || a < b ? plus : -plus;
    x = sign * G.x, y = sign * G.y, z = sign * G.z, bits = G.bits;
  }
  VectorLanes<Lanes> half(std::size_t from) const {
    auto of = [&](WideFloats const& all) { return to_double(from == 0 ? low_half(all) : high_half(all)); };
    return {of(x), of(y), of(z)};
  }
};

} // namespace mesobridge::sdpd
