#pragma once
#include "sdpd/observe/observation.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

/// Fluids in equilibrium are at their set temperature; one whose kinetic temperature is this many times as
/// high, or no number, has a time step that is too long for its motion. Schemes that refuse bad steps of
/// pairs (EMS, AMS) would go on for ever.
inline constexpr double runaway_temperature = 2;
/// While a structure settles it may set more energy free than that: particles of size K up to about their
/// internal energy, which is K times the thermal one; but not more.
constexpr double absurd_temperature(double K) {
  return std::max(100.0, K);
}

/// Throws PhysicsError that names step, time step and temperature once that has happened.
void refuse_runaway(Observation const& now, double dt);

/// Throws PhysicsError when a quantity of the whole system is no finite number: a single particle may have
/// run away in a system that flows.
void refuse_not_finite(Observation const& now, double dt);

} // namespace mesobridge::sdpd
