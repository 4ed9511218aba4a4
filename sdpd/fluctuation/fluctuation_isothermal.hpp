#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Fluctuation and dissipation at a set temperature, pair after pair, for particles without internal energy
/// (DPD): every step is made, since there is no energy that could run out.
template <class Law>
void fluctuate_isothermal(System& system, Law const& law, double dt, bool second);

} // namespace mesobridge::sdpd
