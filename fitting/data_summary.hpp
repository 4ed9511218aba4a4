#pragma once
#include "fitting/eos_data.hpp"
#include <span>

namespace mesobridge::fitting {

/// What the data say at a glance, in SI: fits set their bounds and first values by it. The members that no
/// datum tells hold what is usual.
struct DataSummary {
  double rho_start = 0; ///< where the data start: the least rho0 of shocks, or else the least density
  double rho_min = 0, rho_max = 0;
  double v_min = 0; ///< 1/rho_max [m^3/kg]
  std::optional<double> T_min, T_max;
  double T_coldest = 300; ///< T_min where there is one
  bool energies = false;  ///< energies on a scale of the data's own occur
  // The detonation among the data, the last one of several; its explosive has the energy e_explosive.
  double D_CJ = 7000, P_CJ = 2e10, e_explosive = 0;
};

/// Throws InputError when no observation says its density.
DataSummary summarise(std::span<Observation const> data);

} // namespace mesobridge::fitting
