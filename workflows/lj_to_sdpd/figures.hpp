#pragma once
#include "workflows/lj_to_sdpd/results.hpp"
#include "workflows/report/plot.hpp"

namespace mesobridge::workflows {

/// Isotherms of U* or P*: MD with error bars, fit, published equation of state; below them the relative
/// differences to the fit.
enum class GridQuantity { U, P };
Plot isotherms(ChainResults const& results, GridQuantity quantity);

/// The three published equations of the Lennard-Jones fluid, the fit and MD on three isotherms, as
/// differences to Kolafa and Nezbeda's.
Plot models_and_md(ChainResults const& results, GridQuantity quantity);

/// Predictions of every state by a fit without it, in standard errors.
Plot held_out(ChainResults const& results);

/// Means against the particle size, with the equation of state and the thesis's Table 5.1.
Plot pressure_against_size(ChainResults const& results);
Plot temperatures_against_size(ChainResults const& results);
Plot density_against_size(ChainResults const& results);

/// Variances of energy, density and pressure against the particle size, with the thesis's Table 5.1.
Plot variances_against_size(ChainResults const& results);

/// Distributions of the Lennard-Jones fluid's energies per molecule, densities and pressures.
std::vector<Plot> fluid_distributions(ChainResults const& results);

/// Internal energies of the ideal gas with their exact law, one plot a size.
std::vector<Plot> ideal_gas_distributions(ChainResults const& results);

/// Energy drift against the time step with our power laws and the printed ones.
Plot drift_against_time_step(std::vector<DriftLaw> const& laws);

} // namespace mesobridge::workflows
