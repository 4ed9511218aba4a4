#pragma once
#include "sdpd/state/random.hpp"
#include <functional>
#include <string>
#include <vector>

namespace mesobridge::sdpd {

struct System;

/// What a sub-step may leave as it was: of each particle, or a sum over all of them.
enum class Conserved {
  positions,         ///< each
  momenta,           ///< each
  internal_energies, ///< each
  entropies,         ///< each; where the internal energy alone decides the entropy (DPDE), that
  momentum,          ///< sum
  internal_energy,   ///< sum
  energy             ///< total; friction and noise of particles without internal energies do not keep it
};

/// When a sub-step comes: in every step, or in one of `every` steps.
struct Turn {
  std::uint32_t every = 1, at = 0;

  bool comes(std::uint64_t step) const { return step % every == at; }
};

/// A part of a step, which says what it is. A scheme is a list of them.
struct SubStep {
  std::string name;
  std::vector<Conserved> conserves; ///< each particle's to the bit, sums to round-off
  std::vector<Stream> noise;        ///< the streams that it draws from
  std::function<void(System&)> run;
  Turn turn = {};
};

} // namespace mesobridge::sdpd
