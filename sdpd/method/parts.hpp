#pragma once
#include "sdpd/conduction/heat_conduction.hpp"
#include "sdpd/friction/list.hpp"
#include "sdpd/kernel/list.hpp"
#include "sdpd/kinetics/list.hpp"
#include "sdpd/potential/list.hpp"
#include "sdpd/state/species.hpp"
#include "sdpd/thermodynamics/thermodynamics.hpp"

namespace mesobridge::sdpd {

/// What a method puts into a System, in reduced units.
struct MethodParts {
  std::unique_ptr<Thermodynamics const> thermodynamics; ///< none without internal energies
  AnyKernel kernel;                                     ///< of the densities, where there are any
  double self_density;                                  ///< what a particle adds to its own density
  DensitySum density_sum = DensitySum::mass;
  AnyPotential potential;
  AnyPairLaw law; ///< friction and noise
  AnyConduction conduction;
  double boltzmann;
  std::optional<Reaction> reaction = {};
};

} // namespace mesobridge::sdpd
