#pragma once
#include "sdpd/setup/viscosity_line.hpp"

namespace mesobridge::sdpd {

/// The least viscosity that a fluid has with any friction of its pairs, as far as trials tell.
struct ViscosityFloor {
  double pairs = 0; ///< with which it has that
  cg::Estimate realised;
  bool between = false; ///< trials lie on both sides, and surely rise towards less friction
};

/// Where trials rise towards less friction, the least value of a parabola in ln pairs through those about the
/// lowest, with the error that theirs make of it; else what the trial of least friction leaves when that is
/// taken down to `least_pairs`, about as much as it is (sdpd/README.md, Eq. (S109)). Of one trial at least.
ViscosityFloor viscosity_floor(std::span<ViscosityTrial const> trials, double least_pairs);

} // namespace mesobridge::sdpd
