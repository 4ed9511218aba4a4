#pragma once
#include "sdpd/observe/equilibrium.hpp"

namespace mesobridge::sdpd {

/// The energy drift from the random walk of the energy, where the walk hides its own mean.
///
/// The conservative step keeps volumes in phase space, and a step of fluctuation and dissipation leaves the
/// canonical law as it is; so the energy W that a time span brings to a system at equilibrium obeys
/// <exp(-W/k_B T)> = 1 (sdpd/README.md, Eq. (S32)), and since many particles make W
/// Gaussian, <W> = Var(W) / 2 k_B T. The drift is the heat of the integrator's errors: where they do not
/// scatter, there is none.
///
/// Var(W) over lags of `lag` and twice that, from samples at equal intervals; their difference leaves out the
/// part of the energy error that only wanders to and fro. The rate is that of (E - E_0)/|E_0| per reduced
/// unit of time, its standard error from the scatter of blocks. Valid where fluctuation and dissipation are
/// (nearly) exact: not for SER. `boltzmann` and `T` in the units of the energies.
///
/// Throws InputError when there are not enough samples (see enough_for_energy_walk).
Drift drift_from_energy_walk(std::span<double const> times, std::span<double const> energies, double lag,
                             double boltzmann, double T);

/// Whether the samples, at equal intervals, reach over more than 32 lags, each rounded to whole samples.
bool enough_for_energy_walk(std::span<double const> times, double lag);

} // namespace mesobridge::sdpd
