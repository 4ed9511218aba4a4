#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Sets system.rates, in the order of ids, by the particles' progress, temperatures and pressures of now and
/// the neighbours of the last sum of the densities. A pair law leaves out blocks of particles in which the
/// hottest pair would change lambda by less than 1e-18 within h: no number of the run could tell. `Law` is
/// one of AnyKinetics that has rates.
template <class Law>
void find_rates(System& system, Law const& law, double h);

} // namespace mesobridge::sdpd
