#pragma once
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Domains along each edge of the box for the hybrid scheme.
inline constexpr std::uint32_t hybrid_domains = 2;

/// The hybrid of SSA and SER (thesis, section 4.2.2, after Homman, Maillet, Roussel and Stoltz): the box is
/// cut into hybrid_domains^3 equal domains, as if each belonged to a processor of its own. Pairs within a
/// domain take their steps one after the other (SSA), then those that two domains share all at once (SER).
/// Conserves momentum and energy to round-off; throws PhysicsError when an energy leaves the equation of
/// state.
void fluctuate_hybrid(System& system, double dt, bool second = false);

} // namespace mesobridge::sdpd
