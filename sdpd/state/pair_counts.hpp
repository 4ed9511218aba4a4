#pragma once
#include <cstdint>

namespace mesobridge::sdpd {

/// Steps of pairs since the start, and those that were not made.
struct PairCounts {
  std::uint64_t proposed = 0;
  std::uint64_t out_of_domain = 0; ///< they would have left the equation of state (AMS, EMS)
  std::uint64_t metropolis = 0;    ///< the Metropolis test failed (EMS)

  PairCounts& operator+=(PairCounts const& o) {
    proposed += o.proposed, out_of_domain += o.out_of_domain, metropolis += o.metropolis;
    return *this;
  }
};

} // namespace mesobridge::sdpd
