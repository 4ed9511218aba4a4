#pragma once
#include "sdpd/system/sub_step.hpp"

namespace mesobridge::sdpd {

/// Accelerates all particles over dt by the body force and notes its work (sdpd/README.md, Eq. (S54)). It
/// waits while walls are held.
SubStep body_force(double dt);

} // namespace mesobridge::sdpd
