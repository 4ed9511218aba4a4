#pragma once
#include "md/metal.hpp"

namespace mesobridge::md {

/// What a shock starts from, where it shall lead to, and where a run may begin.
struct ShockTarget {
  MetalState initial;
  double P0 = 0, e0 = 0; ///< of the initial state [Pa], [J/kg], its energy as in MetalSample
  double P = 0;          ///< behind the shock [Pa]
  MetalState nearby;     ///< a state near the one behind the shock
};

struct HugoniostatSample {
  double T = 0;   ///< [K]
  double rho = 0; ///< [kg/m^3]
  double e = 0;   ///< as in MetalSample [J/kg]
  double P = 0;   ///< [Pa]
};

/// Samples the state behind a shock of a given pressure by LAMMPS's `fix nphug`: a crystal under a barostat
/// that is the same in all directions, whose thermostat drives it towards e - e0 = (P + P0)(1/rho0 - 1/rho)/2
/// (md/README.md, Eq. (M6)). A second way to the Hugoniot curve, beside states of the
/// canonical ensemble. Steps, seed and time step as in `settings`. `consume` gets each sample; false stops
/// the run, and then this returns false. Throws InputError as `check`, LammpsError.
bool sample_hugoniostat(MpiWorld const& world, ShockTarget const& target, MetalSettings const& settings,
                        std::function<bool(HugoniostatSample const&)> const& consume, Log log = Log::replace);

} // namespace mesobridge::md
