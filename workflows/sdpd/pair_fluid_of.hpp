#pragma once
#include "sdpd/method/pair_fluid.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// What a DPD or DPDE scene says of its particles: mass, potential, friction and, for DPDE, internal energy.
/// Throws InputError.
sdpd::PairFluid pair_fluid_of(Scene const& scene);

} // namespace mesobridge::workflows
