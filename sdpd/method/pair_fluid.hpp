#pragma once
#include "fitting/internal_energy.hpp"
#include "sdpd/conduction/heat_conduction.hpp"
#include "sdpd/friction/list.hpp"
#include "sdpd/method/species.hpp"
#include "sdpd/potential/list.hpp"
#include "sdpd/state/units.hpp"
#include <optional>

namespace mesobridge::sdpd {

/// What the particles of DPD and DPDE have in place of an equation of state, a kernel and viscosities. In the
/// units of the settings (SI, or any set of units with k_B = 1).
struct PairFluid {
  double mass;          ///< of a particle, > 0
  double boltzmann = 1; ///< k_B
  AnyPotential potential;
  AnyFrictionShape friction;                                 ///< friction coefficients at the set temperature
  std::optional<fitting::AnyInternalEnergy> internal_energy; ///< DPDE; without it DPD
  /// DPDE: kappa chi^2 of DpdeConduction, in energy times temperature over time, as the weight along the line
  /// of centres; without it particles exchange heat by friction alone.
  std::optional<AnyFrictionShape> conduction = {};
  /// Several species, whose masses and internal energies take the place of those above; `mass` remains the
  /// unit of mass.
  std::vector<PairSpecies> species = {};

  bool follows_energy() const { return internal_energy.has_value(); }
  double friction_cutoff() const;
  /// The largest cut-off of the potential, the friction and the conduction.
  double range() const;

  /// The customary units of DPD: m, the friction's cut-off and k_B T are one.
  ReducedUnits units(double T) const;
  AnyPairLaw law(ReducedUnits const& units) const;
  AnyPotential reduced_potential(ReducedUnits const& units) const;
  AnyConduction reduced_conduction(ReducedUnits const& units) const;
};

/// Throws InputError that names the quantity that is out of bounds.
void check(PairFluid const& fluid);

} // namespace mesobridge::sdpd
