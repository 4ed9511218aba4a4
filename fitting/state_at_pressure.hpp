#pragma once
#include "fitting/fluid.hpp"

namespace mesobridge::fitting {

/// The state of a density that has this pressure: the lowest temperature at which it comes to it, to
/// round-off. Throws InputError unless both are finite and rho > 0; PhysicsError where the fluid has no such
/// state within its temperatures.
EosState state_at_pressure(Fluid const& fluid, double rho, double P);

} // namespace mesobridge::fitting
