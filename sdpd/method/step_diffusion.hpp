#pragma once
#include "sdpd/method/settings.hpp"

namespace mesobridge::sdpd {

/// The rate at which friction makes a particle's velocity forget in a fluid without structure, reduced (the
/// omega of sdpd/README.md, Eq. (S55)). Of one species; 0 without friction.
double velocity_decay_rate(SimulationSettings const& settings);

/// By which share a step between two of friction, of this reduced length, makes self-diffusion too large
/// (sdpd/README.md, Eq. (S92)).
double diffusion_excess(double rate, double step);

/// The step that makes it too large by the share, 0 < share < 1; infinite without friction.
double step_of_diffusion_excess(double rate, double share);

} // namespace mesobridge::sdpd
