#pragma once

namespace mesobridge::sdpd {

struct System;

/// Total energy, kinetic, internal and of the pair potential; summed in an order that does not depend on the
/// threads.
double total_energy(System const& system);

} // namespace mesobridge::sdpd
