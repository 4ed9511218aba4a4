#pragma once
#include "cg/estimate.hpp"
#include <span>

namespace mesobridge::sdpd {

/// Viscosities in the units of the method.
struct ViscosityTrial {
  double pairs = 0;      ///< that the friction of pairs was given
  cg::Estimate realised; ///< that waves of the fluid have
};

/// What a fluid has with so much friction of pairs, by all trials near it, of which one at least is there
/// (sdpd/README.md, Eq. (S108)): the trial that ended a search because it came out right is one of them.
cg::Estimate realised_by_line(std::span<ViscosityTrial const> trials, double pairs);

} // namespace mesobridge::sdpd
