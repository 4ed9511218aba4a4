#pragma once
#include "sdpd/thermodynamics/mixed_particle.hpp"

namespace mesobridge::sdpd {

/// What a particle is by its progress lambda (sdpd/README.md, Eq. (S60)): the pure reactant below the first,
/// the pure product above the second, a mixture in between. What a particle changes into takes over its
/// energy and density, so that T and P jump and no energy moves.
inline constexpr double pure_below = 1e-4, pure_above = 1 - 1e-6;

/// From this progress on what is left of the reactant burns at once where its mixture comes to an end
/// (sdpd/README.md, Eq. (S66)).
inline constexpr double nearly_burnt = 0.9;

/// Of particles of a reactant and its product, each by its progress. Pure ones cost what they do without a
/// reaction. Throws InputError as make_thermodynamics does, and for models that cannot be mixed.
std::unique_ptr<Thermodynamics const> make_reacting_thermodynamics(ReactingModels const& models,
                                                                   ReducedUnits const& units,
                                                                   CentreOfMass centre_of_mass);

} // namespace mesobridge::sdpd
