#pragma once
#include "md/box.hpp"
#include "sdpd/state/pair_counts.hpp"
#include <vector>

namespace mesobridge::sdpd {

/// All that a later run needs to go on bit for bit; particles in the order of memory.
struct Checkpoint {
  std::uint64_t step = 0;
  std::vector<std::uint32_t> id;
  std::vector<Vec3> q, q_at_renewal, p;
  std::vector<double> eps, S, T;
  double kept_energy = 0; ///< see Scheme::keep_energy
  PairCounts pair_counts, conduction_counts;
};

} // namespace mesobridge::sdpd
