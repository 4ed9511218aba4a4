#pragma once
#include "cg/hugoniot.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// What LAMMPS's Hugoniostat gives at the pressure of a point of the curve.
struct HugoniostatCheck {
  double P = 0; ///< [Pa], set
  cg::Estimate T, rho, e;
  cg::Estimate
      residual; ///< of the Hugoniot equation over the run, e - e0 - (P + P0)(1/rho0 - 1/rho)/2 [J/kg]
  /// Differences to the point, in standard errors of both: T, rho, e. A change of P by its error moves the
  /// point along the curve, by far less than the Hugoniostat's own errors; it is left out.
  double T_deviation = 0, rho_deviation = 0, e_deviation = 0;
};

/// Runs the Hugoniostat at the pressure of each point, for three times the steps of a state since its
/// thermostat and barostat settle slowly, one after the other in this process, with progress. Throws
/// Interrupted.
std::vector<HugoniostatCheck> check_by_hugoniostat(cg::MetalPoint const& initial,
                                                   std::span<cg::HugoniotPoint const> points,
                                                   md::MetalSettings const& settings, Context const& context);

Json hugoniostat_json(std::span<HugoniostatCheck const> checks);
std::string hugoniostat_text(std::span<HugoniostatCheck const> checks);

} // namespace mesobridge::workflows
