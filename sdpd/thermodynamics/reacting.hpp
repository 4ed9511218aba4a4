#pragma once
#include "fitting/eos/mixture_parts.hpp"
#include "sdpd/thermodynamics/mixed_particle.hpp"

namespace mesobridge::sdpd {

/// What a particle is by its progress lambda (sdpd/README.md, Eq. (S60)): the pure reactant below the first,
/// the pure product above the second, a mixture in between. What a particle changes into takes over its
/// energy and density, so that T and P jump and no energy moves.
inline constexpr double pure_below = fitting::PureProgress{}.reactant_below,
                        pure_above = fitting::PureProgress{}.product_above;

/// From the second progress on what is left of a reactant burns at once, and up to the first a trace of
/// product does not count, where the balance with it comes to an end (sdpd/README.md, Eqs. (S66), (S67)).
inline constexpr double hardly_burnt = 0.1, nearly_burnt = 0.5;

/// What particles have in the place of ln(rho_1/rho_0) whose trace of product does not count.
inline constexpr double no_product = -1e3;

/// Of particles of a reactant and its product, each by its progress. Pure ones cost what they do without a
/// reaction. Throws InputError as make_thermodynamics does, and for models that cannot be mixed.
std::unique_ptr<Thermodynamics const> make_reacting_thermodynamics(ReactingModels const& models,
                                                                   ReducedUnits const& units,
                                                                   CentreOfMass centre_of_mass);

} // namespace mesobridge::sdpd
