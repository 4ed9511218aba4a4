#pragma once

namespace mesobridge::sdpd {

/// What a potential u gives a pair at distance r: its energy, and the force on the first particle as
/// strength * r_ij, strength = -u'(r)/r. X is a number or lanes of numbers.
template <class X>
struct PairForce {
  X energy, strength;
};

} // namespace mesobridge::sdpd
