#pragma once
#include "sdpd/method/step_diffusion.hpp"
#include "workflows/study/trade_off.hpp"

namespace mesobridge::workflows {

/// The reduced time step whose excess of self-diffusion is at most the share, of a particle alone in the
/// scene's fluid (sdpd/README.md, Eq. (S92)); infinite without friction.
double dt_by_bound(Scene const& scene, double share);

/// That excess of a reduced time step.
double excess_by_bound(Scene const& scene, double dt);

/// What a configuration's trials say of that excess (S93).
sdpd::DiffusionAgainstStep diffusion_against_step(TradeOff const& found, Configuration const& of);

/// The largest time step of a configuration whose self-diffusion is too large by the share at most, as far as
/// its trials tell.
double largest_dynamic_dt(TradeOff const& found, Configuration const& of, double share);

} // namespace mesobridge::workflows
