#pragma once
#include "sdpd/state/pair_counts.hpp"
#include "sdpd/state/particles.hpp"

namespace mesobridge::sdpd {

/// All that a later run needs to go on bit for bit; particles in the order of memory, with ids, positions,
/// momenta and the fields that are checkpointed.
struct Checkpoint {
  std::uint64_t step = 0;
  Particles particles;
  std::vector<Vec3> q_at_renewal; ///< of the neighbour lists
  double kept_energy = 0;         ///< see Scheme::keep_energy
  PairCounts pair_counts, conduction_counts;
  /// Where there are walls: their time, and the impulse and work of each.
  std::vector<double> walls = {};
  /// Where walls have friction or there is a body force: impulse (x, y, z) of the friction and heat of each
  /// wall, the body force's work and the heat of its sink.
  std::vector<double> flow = {};
  /// Where particles react: the time since the reaction began, and both rates by id if they are kept.
  std::vector<double> reaction = {};
};

} // namespace mesobridge::sdpd
