#pragma once
#include "fitting/eos_data.hpp"

namespace mesobridge::fitting {

/// Relative standard error of an initial density that comes without one: densities of samples are known so
/// well. A pressure at rest is as uncertain as the model's bulk modulus makes this.
inline constexpr double error_of_initial_density = 1e-3;

/// A shock into matter of known density and temperature also says that this matter is at rest: P(rho_0, T_0)
/// = P_0. Adds this as a datum for every such start that is not among the states of the data: the pressure
/// with its own standard error (if none is given 1e5 Pa, the atmosphere), at a density with its own error (if
/// neither is given, error_of_initial_density). Returns a sentence a start that says so.
std::vector<std::string> add_states_at_rest(std::vector<Observation>& data);

} // namespace mesobridge::fitting
