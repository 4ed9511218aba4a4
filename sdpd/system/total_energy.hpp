#pragma once

namespace mesobridge::sdpd {

struct System;

/// sum m_i (1 - lambda_i) q of particles that react, with the heat of reaction q (sdpd/README.md, Eq. (S64)).
double chemical_energy(System const& system);

/// Total energy, kinetic, internal, chemical and of the pair potential; summed in an order that does not
/// depend on the threads.
double total_energy(System const& system);

} // namespace mesobridge::sdpd
