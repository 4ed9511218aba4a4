#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// fluctuate() pair after pair, with the same noise, in double precision and with exact inversions of the
/// equation of state: its oracle. Not for SER.
void fluctuate_plain(System& system, PairScheme scheme, double dt, bool second = false);

/// conduct() with the same noise in double precision and with exact inversions of the equation of state: its
/// oracle. For SSA, AMS and EMS.
void conduct_plain(System& system, PairScheme scheme, double dt, bool second = false);

} // namespace mesobridge::sdpd
